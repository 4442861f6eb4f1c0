/**
 * The static background: floor, hairlines, blocks and their outline. Draws only what is inside the
 * port, with one path per kind of line. 9,000 cells take a few milliseconds, once per maze, size or
 * theme.
 */
import { CELL, isBlock, type MazeDocument } from "@corridor/maze";
import type { VectorContext } from "../drawing/drawing-context.ts";
import type { Palette } from "../drawing/palette.ts";
import { visibleCells, viewX, viewY, type CellRange, type Viewport } from "../drawing/viewport.ts";

/** Below this many pixels the seams of a cell would hide it. */
const SEAM_FROM_PX = 8;

/** Draws floor, grid and blocks inside the port. */
export function drawWalls(
  context: VectorContext,
  viewport: Viewport,
  palette: Palette,
  maze: MazeDocument,
): void {
  const range = visibleCells(viewport);
  const cellPx = viewport.scale * CELL;
  const left = viewX(viewport, range.fromColumn * CELL);
  const top = viewY(viewport, range.fromRow * CELL);
  const width = (range.toColumn - range.fromColumn) * cellPx;
  const height = (range.toRow - range.fromRow) * cellPx;
  context.fillStyle = palette.floor;
  context.fillRect(left, top, width, height);
  if (cellPx >= SEAM_FROM_PX) {
    context.beginPath();
    for (let column = range.fromColumn + 1; column < range.toColumn; column++) {
      const x = viewX(viewport, column * CELL);
      line(context, x, top, x, top + height);
    }
    for (let row = range.fromRow + 1; row < range.toRow; row++) {
      const y = viewY(viewport, row * CELL);
      line(context, left, y, left + width, y);
    }
    stroke(context, palette.floorLine, 1);
  }
  fillBlocks(context, viewport, palette, maze, range);
  if (cellPx >= SEAM_FROM_PX) {
    context.beginPath();
    eachBorder(range, (column, row, isVertical) => {
      const here = isBlock(maze, column, row);
      const before = isVertical ? isBlock(maze, column - 1, row) : isBlock(maze, column, row - 1);
      if (here && before) border(context, viewport, column, row, isVertical);
    });
    stroke(context, palette.wallSeam, 1);
  }
  context.beginPath();
  eachBorder(range, (column, row, isVertical) => {
    const here = isBlock(maze, column, row);
    const before = isVertical ? isBlock(maze, column - 1, row) : isBlock(maze, column, row - 1);
    if (here !== before) border(context, viewport, column, row, isVertical);
  });
  context.lineCap = "square";
  stroke(context, palette.wallEdge, 1.5);
  drawFrame(context, viewport, palette);
}

/** One rectangle for each run of blocks in a row. */
function fillBlocks(
  context: VectorContext,
  viewport: Viewport,
  palette: Palette,
  maze: MazeDocument,
  range: CellRange,
): void {
  const cellPx = viewport.scale * CELL;
  context.fillStyle = palette.wall;
  for (let row = range.fromRow; row < range.toRow; row++) {
    let column = range.fromColumn;
    while (column < range.toColumn) {
      const from = column;
      while (column < range.toColumn && isBlock(maze, column, row)) column++;
      if (column > from) {
        const x = viewX(viewport, from * CELL);
        context.fillRect(x, viewY(viewport, row * CELL), (column - from) * cellPx, cellPx);
      } else {
        column++;
      }
    }
  }
}

/** The edge of the grid, which is solid. */
function drawFrame(context: VectorContext, viewport: Viewport, palette: Palette): void {
  const x = viewX(viewport, 0);
  const y = viewY(viewport, 0);
  const width = viewport.columns * CELL * viewport.scale;
  const height = viewport.rows * CELL * viewport.scale;
  context.beginPath();
  context.roundRect(x, y, width, height, 3);
  stroke(context, palette.wallEdge, 3);
}

/** Visits the left and top side of every cell in the range, except the maze's own frame. */
function eachBorder(
  range: CellRange,
  visit: (column: number, row: number, isVertical: boolean) => void,
): void {
  for (let row = range.fromRow; row < range.toRow; row++) {
    for (let column = range.fromColumn; column < range.toColumn; column++) {
      if (column > 0) visit(column, row, true);
      if (row > 0) visit(column, row, false);
    }
  }
}

function border(
  context: VectorContext,
  viewport: Viewport,
  column: number,
  row: number,
  isVertical: boolean,
): void {
  const x = viewX(viewport, column * CELL);
  const y = viewY(viewport, row * CELL);
  const cellPx = viewport.scale * CELL;
  line(context, x, y, isVertical ? x : x + cellPx, isVertical ? y + cellPx : y);
}

function line(
  context: VectorContext,
  fromX: number,
  fromY: number,
  toX: number,
  toY: number,
): void {
  context.moveTo(fromX, fromY);
  context.lineTo(toX, toY);
}

function stroke(context: VectorContext, colour: string, width: number): void {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.stroke();
}
