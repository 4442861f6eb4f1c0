/** Start and goals: a dashed square with the start heading, and a flag. */
import { CELL, type Cell, type HeadingName, type MazeDocument, type Start } from "@corridor/maze";
import type { VectorContext } from "../drawing/drawing-context.ts";
import type { Palette } from "../drawing/palette.ts";
import { svgPath } from "../drawing/svg-path.ts";
import { visibleCells, viewX, viewY, type Box, type Viewport } from "../drawing/viewport.ts";

/** Translated labels. */
export interface PlaceWords {
  startWord: string;
  goalWord: string;
}

/** Smallest cell, in pixels, with a readable label. */
const WORD_FROM_PX = 60;
/**
 * Smallest cell, in pixels, in which the label of the start is readable below a robot that stands
 * there. Its wheels reach 27 units.
 */
const START_WORD_FROM_PX = 76;
/** Pixels from the middle of a goal down to the middle of its label. */
const WORD_DOWN_PX = 16;
/** Side in pixels of the largest flag. */
const FLAG_PX = 22;
/** Lucide's "flag", in its 24 x 24 box, as in the tool strip. */
const FLAG = "M5 21v-6.2M5 14.8c6.6-4.4 8.4 2.6 15 0V4.2c-6.6 2.6-8.4-4.4-15 0z";

const quarterTurns: Record<HeadingName, number> = { north: 0, east: 1, south: 2, west: 3 };

/** Draws start and goals inside the port. */
export function drawPlaces(
  context: VectorContext,
  viewport: Viewport,
  palette: Palette,
  maze: MazeDocument,
  words: PlaceWords,
): void {
  const range = visibleCells(viewport);
  const isVisible = ({ column, row }: Cell): boolean =>
    column >= range.fromColumn &&
    column < range.toColumn &&
    row >= range.fromRow &&
    row < range.toRow;
  for (const goal of maze.goals) {
    if (isVisible(goal)) drawGoal(context, cellBox(viewport, goal), palette, words.goalWord);
  }
  if (isVisible(maze.start)) {
    drawStart(context, cellBox(viewport, maze.start), palette, maze.start, words.startWord);
  }
}

/** Pixels of one cell. */
export function cellBox(viewport: Viewport, cell: Cell): Box {
  const side = viewport.scale * CELL;
  return {
    x: viewX(viewport, cell.column * CELL),
    y: viewY(viewport, cell.row * CELL),
    width: side,
    height: side,
  };
}

/** The part of a goal's cell that identifies it: flag and label. */
export function goalPicture(cell: Box): Box {
  const flag = Math.min(FLAG_PX, cell.width * 0.6);
  const hasWord = cell.width >= WORD_FROM_PX;
  const above = flag * (hasWord ? 0.95 : 0.5);
  return {
    x: cell.x + (cell.width - flag) / 2,
    y: cell.y + cell.height / 2 - above,
    width: flag,
    height: above + (hasWord ? WORD_DOWN_PX + 6 : flag / 2),
  };
}

/** Draws a goal in one cell. */
export function drawGoal(context: VectorContext, box: Box, palette: Palette, word: string): void {
  const inset = Math.max(1.5, box.width * 0.04);
  context.beginPath();
  context.roundRect(
    box.x + inset,
    box.y + inset,
    box.width - 2 * inset,
    box.height - 2 * inset,
    Math.min(6, box.width * 0.12),
  );
  context.fillStyle = palette.goodBg;
  context.fill();
  context.strokeStyle = palette.good;
  context.lineWidth = 1.5;
  context.stroke();
  const hasWord = box.width >= WORD_FROM_PX;
  const picture = goalPicture(box);
  const flag = picture.width;
  context.save();
  context.translate(picture.x, picture.y);
  context.scale(flag / 24, flag / 24);
  context.lineWidth = 2.2;
  context.lineJoin = "round";
  context.lineCap = "round";
  context.strokeStyle = palette.goodInk;
  context.stroke(svgPath(FLAG));
  context.restore();
  if (hasWord) {
    label(context, palette, palette.goodInk, word, box, box.y + box.height / 2 + WORD_DOWN_PX);
  }
}

/** Draws the start in one cell, with an arrow head for the start heading. */
export function drawStart(
  context: VectorContext,
  box: Box,
  palette: Palette,
  start: Start,
  word: string,
): void {
  const inset = Math.max(2, box.width * 0.05);
  context.beginPath();
  context.roundRect(
    box.x + inset,
    box.y + inset,
    box.width - 2 * inset,
    box.height - 2 * inset,
    Math.min(5, box.width * 0.1),
  );
  context.strokeStyle = palette.edge;
  context.lineWidth = 1.5;
  context.setLineDash(box.width >= WORD_FROM_PX ? [4, 3] : [3, 2]);
  context.stroke();
  context.setLineDash([]);
  const size = Math.min(7, Math.max(3, box.width * 0.09));
  context.save();
  context.translate(box.x + box.width / 2, box.y + box.height / 2);
  context.rotate((quarterTurns[start.heading] * Math.PI) / 2);
  context.translate(0, -box.width / 2 + inset + 2);
  context.beginPath();
  context.moveTo(-size, size);
  context.lineTo(0, 0);
  context.lineTo(size, size);
  context.closePath();
  context.fillStyle = palette.edge;
  context.fill();
  context.restore();
  if (box.width >= START_WORD_FROM_PX) {
    // A robot that stands here covers the middle; the label stays readable below it.
    const isDown = start.heading === "south";
    const y = isDown ? box.y + inset + 9 : box.y + box.height - inset - 8;
    label(context, palette, palette.ink3, word, box, y);
  }
}

function label(
  context: VectorContext,
  palette: Palette,
  colour: string,
  text: string,
  box: Box,
  y: number,
): void {
  context.font = `600 12px ${palette.font}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = colour;
  context.fillText(text, box.x + box.width / 2, y, box.width - 8);
}
