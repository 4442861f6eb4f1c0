/** Renders a maze as a self-contained SVG file, with the code that draws the stage. */
import { CELL, sizeOf, type MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import { bumpMarks, drawBumps } from "../layers/bumps.ts";
import { drawPlaces, type PlaceWords } from "../layers/places.ts";
import { drawRobot, type Face } from "../layers/robot.ts";
import { drawRulers } from "../layers/rulers.ts";
import { drawTrail } from "../layers/trail.ts";
import { drawWalls } from "../layers/walls.ts";
import type { Palette } from "../drawing/palette.ts";
import { DirtyRects } from "../drawing/dirty-rects.ts";
import type { Viewport } from "../drawing/viewport.ts";
import { escapeText, SvgPen } from "./svg-pen.ts";

/** The robot, its trail and its bumps. */
export interface DrawnRun {
  pose: Pose;
  face: Face;
  /** x and y alternating, in units; ends at the robot */
  points: readonly number[];
  /** positions of the robot's centre at bumps, x and y alternating, in units */
  bumps: readonly number[];
}

export interface PictureScene extends PlaceWords {
  maze: MazeDocument;
  palette: Palette;
  /** null: only the maze */
  run: DrawnRun | null;
  hasRulers: boolean;
}

/** Cells are as large as on a screen, or smaller if the picture would exceed a page. In px. */
const MAX_CELL_PX = 80;
const MIN_CELL_PX = 8;
const PAGE_PX = 1600;
/** Space around the maze in px, for its frame or for the rulers. */
const MARGIN = 8;
const RULERS = { left: 48, top: 32 };

/** @returns the text of the file, and its size in CSS pixels */
export function mazeSvg(scene: PictureScene): { text: string; width: number; height: number } {
  const { maze, palette, run, hasRulers } = scene;
  const { columns, rows } = sizeOf(maze);
  const fitting = Math.floor(PAGE_PX / Math.max(columns, rows));
  const cellPx = Math.min(MAX_CELL_PX, Math.max(MIN_CELL_PX, fitting));
  const left = hasRulers ? RULERS.left : MARGIN;
  const top = hasRulers ? RULERS.top : MARGIN;
  const port = { x: left, y: top, width: columns * cellPx, height: rows * cellPx };
  // Half of a ruler's last number extends beyond the end of the ruler.
  const end = hasRulers ? 2 * MARGIN : MARGIN;
  const width = left + port.width + end;
  const height = top + port.height + end;
  const viewport: Viewport = {
    scale: cellPx / CELL,
    originX: left,
    originY: top,
    port,
    view: { x: 0, y: 0, width, height },
    columns,
    rows,
  };

  const pen = new SvgPen();
  pen.fillStyle = palette.surface;
  pen.fillRect(0, 0, width, height);
  drawWalls(pen, viewport, palette, maze);
  drawPlaces(pen, viewport, palette, maze, scene);
  if (run !== null) {
    drawTrail(pen, viewport, palette, run.points, "round");
    const marks = bumpMarks(maze, run.bumps, run.pose.heading);
    if (marks.length > 0) drawBumps(pen, viewport, palette, marks);
    drawRobot(pen, viewport, palette, run.pose, run.face, new DirtyRects());
  }
  if (hasRulers) drawRulers(pen, viewport, palette);
  const title = maze.name === "" ? "" : `<title>${escapeText(maze.name)}</title>\n`;
  const text =
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" ` +
    `viewBox="0 0 ${width} ${height}">\n${title}${pen.elements()}\n</svg>\n`;
  return { text, width, height };
}
