/**
 * Range sensor: casts one ray from the robot's centre to the first block or the edge of the grid.
 *
 * Grid traversal from cell border to cell border (Amanatides and Woo), so the cost depends on the
 * length of the ray and not on the maze. The result is in units and intentionally without noise.
 * Each crossing is computed from its border, without accumulation, so long rays are as exact as
 * short ones.
 */
import { CELL, type Grid } from "@corridor/maze";

/**
 * Writes the distance from (x, y) along the unit vector (dx, dy) to the first solid cell. It writes
 * to an array because a returned double would be allocated on the heap, four times per tick.
 * @param x, y in units, inside an open cell
 * @param dx, dy a vector of length 1; one of them may be 0
 * @param out receives the distance in units at index `at`
 */
export function writeRange(
  grid: Grid,
  x: number,
  y: number,
  dx: number,
  dy: number,
  out: Float64Array,
  at: number,
): void {
  const { solid, stride } = grid;
  let column = (x / CELL) | 0;
  let row = (y / CELL) | 0;
  let index = (row + 1) * stride + column + 1;

  if (dx === 0) {
    if (dy > 0) {
      while (solid[(index += stride)] === 0) row++;
      out[at] = (row + 1) * CELL - y;
    } else {
      while (solid[(index -= stride)] === 0) row--;
      out[at] = y - row * CELL;
    }
    return;
  }
  if (dy === 0) {
    if (dx > 0) {
      while (solid[++index] === 0) column++;
      out[at] = (column + 1) * CELL - x;
    } else {
      while (solid[--index] === 0) column--;
      out[at] = x - column * CELL;
    }
    return;
  }

  const stepX = dx > 0 ? 1 : -1;
  const stepY = dy > 0 ? 1 : -1;
  const strideY = dy > 0 ? stride : -stride;
  let borderX = (dx > 0 ? column + 1 : column) * CELL;
  let borderY = (dy > 0 ? row + 1 : row) * CELL;
  let alongX = (borderX - x) / dx;
  let alongY = (borderY - y) / dy;
  for (;;) {
    if (alongX < alongY) {
      index += stepX;
      if (solid[index] !== 0) {
        out[at] = alongX;
        return;
      }
      borderX += stepX * CELL;
      alongX = (borderX - x) / dx;
    } else {
      index += strideY;
      if (solid[index] !== 0) {
        out[at] = alongY;
        return;
      }
      borderY += stepY * CELL;
      alongY = (borderY - y) / dy;
    }
  }
}
