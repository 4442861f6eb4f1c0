/** Draws one picture of a student's run: maze, path and robot. */
import { CELL, sizeOf, type MazeDocument } from "@corridor/maze";
import { DirtyRects } from "../../stage/drawing/dirty-rects.ts";
import type { Palette } from "../../stage/drawing/palette.ts";
import type { Box } from "../../stage/drawing/viewport.ts";
import { drawRobot, type Face } from "../../stage/layers/robot.ts";
import { blocksPath, edgesPath } from "../../ui/maze-outline.ts";
import type { ShownTile } from "./tile-motion.ts";

/** The robot is larger than in the maze, so that its face can be seen. */
const ROBOT_SIZE = 1.5;
const none: Box = { x: 0, y: 0, width: 0, height: 0 };
/** A picture is always drawn as a whole. */
const dirty = new DirtyRects();

/** Position of the maze in a picture, in device pixels. */
interface PictureView {
  cell: number;
  x: number;
  y: number;
  columns: number;
  rows: number;
}

export function viewOf(maze: MazeDocument, { x, y, width, height }: Box): PictureView {
  const { columns, rows } = sizeOf(maze);
  const cell = Math.min((width - 2) / columns, (height - 2) / rows);
  const left = x + (width - cell * columns) / 2;
  return { cell, x: left, y: y + (height - cell * rows) / 2, columns, rows };
}

/** The picture of a maze without a robot. */
export function drawFloor(
  maze: MazeDocument,
  width: number,
  height: number,
  palette: Palette,
): OffscreenCanvas {
  const picture = new OffscreenCanvas(width, height);
  const context = picture.getContext("2d");
  if (context !== null) drawMaze(context, viewOf(maze, { ...none, width, height }), maze, palette);
  return picture;
}

function drawMaze(
  context: OffscreenCanvasRenderingContext2D,
  { cell, x, y, columns, rows }: PictureView,
  maze: MazeDocument,
  palette: Palette,
): void {
  const mark = 0.26;
  context.translate(x, y);
  context.scale(cell, cell);
  context.lineWidth = 1.25 / cell;
  context.fillStyle = palette.floor;
  context.fillRect(0, 0, columns, rows);
  context.fillStyle = palette.wall;
  context.fill(new Path2D(blocksPath(maze)));
  context.strokeStyle = palette.wallEdge;
  context.stroke(new Path2D(edgesPath(maze)));
  context.strokeRect(0, 0, columns, rows);
  context.fillStyle = palette.good;
  for (const { column, row } of maze.goals) {
    context.fillRect(column + 0.5 - mark, row + 0.5 - mark, 2 * mark, 2 * mark);
  }
  context.beginPath();
  context.arc(maze.start.column + 0.5, maze.start.row + 0.5, mark, 0, 2 * Math.PI);
  context.fillStyle = palette.surface;
  context.fill();
  context.stroke();
}

/** Draws path and robot. Nothing of them leaves the box. */
export function drawRun(
  context: OffscreenCanvasRenderingContext2D,
  box: Box,
  view: PictureView,
  shown: ShownTile,
  palette: Palette,
  isSolved: boolean,
): void {
  context.save();
  context.beginPath();
  context.rect(box.x, box.y, box.width, box.height);
  context.clip();
  drawPath(context, view, shown, isSolved ? palette.good : palette.live);
  drawLargeRobot(context, view, shown, palette, isSolved);
  context.restore();
}

function drawPath(
  context: OffscreenCanvasRenderingContext2D,
  { cell, x, y }: PictureView,
  { trail }: ShownTile,
  colour: string,
): void {
  context.beginPath();
  for (const point of trail) {
    context.lineTo(x + (point.x / CELL) * cell, y + (point.y / CELL) * cell);
  }
  context.strokeStyle = colour;
  context.lineWidth = Math.max(1.5, cell * 0.14);
  context.lineJoin = "round";
  context.lineCap = "round";
  context.stroke();
}

function drawLargeRobot(
  context: OffscreenCanvasRenderingContext2D,
  { cell, x, y, columns, rows }: PictureView,
  { pose, tile: { state } }: ShownTile,
  palette: Palette,
  isSolved: boolean,
): void {
  const scale = (cell / CELL) * ROBOT_SIZE;
  const centre = { x: x + (pose.x / CELL) * cell, y: y + (pose.y / CELL) * cell };
  const viewport = {
    scale,
    originX: centre.x - pose.x * scale,
    originY: centre.y - pose.y * scale,
    port: none,
    view: none,
    columns,
    rows,
  };
  const face: Face = isSolved ? "solved" : state === "bumped" ? "bumped" : "driving";
  dirty.reset();
  drawRobot(context, viewport, palette, pose, face, dirty);
}

/** Makes a picture grey and pale. Not all browsers have filters of canvases. */
export function fade(
  context: OffscreenCanvasRenderingContext2D,
  box: Box,
  { cell, x, y, columns, rows }: PictureView,
): void {
  context.save();
  context.globalCompositeOperation = "saturation";
  context.fillStyle = "gray";
  context.fillRect(x, y, columns * cell, rows * cell);
  context.globalCompositeOperation = "destination-out";
  context.fillStyle = "rgb(0 0 0 / 45%)";
  context.fillRect(box.x, box.y, box.width, box.height);
  context.restore();
}
