/** Marks of a script over the cells of the maze: colours, assumed walls and texts. */
import { CELL } from "@corridor/maze";
import type { CellMark, MarkColor } from "@corridor/protocol";
import type { DrawingContext } from "../drawing/drawing-context.ts";
import type { Palette } from "../drawing/palette.ts";
import { viewX, viewY, visibleCells, type Viewport } from "../drawing/viewport.ts";

/** Below this many pixels a text is unreadable. */
const MIN_FONT_PX = 7;
const MAX_FONT_PX = 20;
/** Part of the cell's width for a text. */
const TEXT_WIDTH = 0.9;
/** The floor shows through. */
const ALPHA = 0.45;
const MIN_WALL_PX = 2;

/** The colours of micromouse simulators. They have the same meaning in every theme. */
const fills: Record<MarkColor, string> = {
  black: "#000000",
  blue: "#0000b3",
  gray: "#b3b3b3",
  cyan: "#006666",
  green: "#00b300",
  orange: "#b36600",
  red: "#cc0000",
  white: "#ffffff",
  yellow: "#b3b300",
  "dark-blue": "#000033",
  "dark-cyan": "#003333",
  "dark-gray": "#1a1a1a",
  "dark-green": "#004d00",
  "dark-orange": "#331a00",
  "dark-red": "#4d0000",
  "dark-violet": "#330033",
  "dark-yellow": "#333300",
};

/** Draws the marks inside the port, over the floor and below the robot. */
export function drawMarks(
  context: DrawingContext,
  viewport: Viewport,
  palette: Palette,
  marks: readonly CellMark[],
): void {
  const { fromColumn, toColumn, fromRow, toRow } = visibleCells(viewport);
  const visible = marks.filter(
    ({ column, row }) => column >= fromColumn && column < toColumn && row >= fromRow && row < toRow,
  );
  const side = viewport.scale * CELL;
  const left = (mark: CellMark): number => viewX(viewport, mark.column * CELL);
  const top = (mark: CellMark): number => viewY(viewport, mark.row * CELL);
  context.save();
  context.globalAlpha = ALPHA;
  for (const mark of visible) {
    if (mark.color === null) continue;
    context.fillStyle = fills[mark.color];
    context.fillRect(left(mark), top(mark), side, side);
  }
  context.globalAlpha = 1;
  drawWalls();
  drawTexts();
  context.restore();

  /** Lines inside the cell, beside the wall. */
  function drawWalls(): void {
    const width = Math.max(MIN_WALL_PX, side * 0.04);
    const near = width / 2;
    const far = side - near;
    context.strokeStyle = palette.liveInk;
    context.lineWidth = width;
    context.beginPath();
    for (const mark of visible) {
      const [x, y] = [left(mark), top(mark)];
      const line = (fromX: number, fromY: number, toX: number, toY: number): void => {
        context.moveTo(x + fromX, y + fromY);
        context.lineTo(x + toX, y + toY);
      };
      if (mark.walls.includes("n")) line(0, near, side, near);
      if (mark.walls.includes("e")) line(far, 0, far, side);
      if (mark.walls.includes("s")) line(0, far, side, far);
      if (mark.walls.includes("w")) line(near, 0, near, side);
    }
    context.stroke();
  }

  function drawTexts(): void {
    const font = Math.min(MAX_FONT_PX, side * 0.4);
    if (font < MIN_FONT_PX) return;
    context.font = `600 ${font}px ${palette.font}`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillStyle = palette.ink;
    // Texts may be longer than the cell is wide: they are condensed.
    for (const mark of visible) {
      if (mark.text === "") continue;
      context.fillText(mark.text, left(mark) + side / 2, top(mark) + side / 2, side * TEXT_WIDTH);
    }
  }
}
