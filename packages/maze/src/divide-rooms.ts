/**
 * Rectangular rooms joined by doors and, in larger mazes, by corridors: the floor plan of a school.
 * An area is divided by a wall with a door, or by a corridor with a door to either side, until what is
 * left is as small as a room. Walls stand on even cells and doors on odd ones, so that no later wall
 * meets a door.
 */
import { type CellRows, openCell, solidRows } from "./carve-tree.ts";
import { BLOCK } from "./maze-limits.ts";
import type { Random } from "./random.ts";

/** An area in lattice cells: lattice cell (i, j) is the maze's cell (2i + 1, 2j + 1). */
interface Area {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** Shortest and longest side of a room in lattice cells: 3 and 9 cells. */
const LEAST = 2;
const MOST = 5;
/** From this length on an area may be divided by a corridor: two rooms, two walls and the corridor. */
const CORRIDOR_FROM = 2 * LEAST + 3;
/** How many of a hundred areas that may have a corridor get one, and how many of those that could stay whole do. */
const CORRIDOR_PERCENT = 40;
const WHOLE_PERCENT = 45;

/**
 * Divides the inside of a maze.
 * @param columns odd and at least 5, as `rows`
 * @returns every room at least 3 by 3 cells, all open cells joined
 */
export function divideRooms(columns: number, rows: number, random: Random): CellRows {
  const grid = solidRows(columns, rows);
  for (let row = 1; row < rows - 1; row += 1) {
    for (let column = 1; column < columns - 1; column += 1) openCell(grid, column, row);
  }
  const areas: Area[] = [{ left: 0, top: 0, width: (columns - 1) / 2, height: (rows - 1) / 2 }];
  for (let area = areas.pop(); area !== undefined; area = areas.pop()) {
    if (isRoom(area, random)) continue;
    areas.push(...divide(grid, area, random));
  }
  return grid;
}

/** Whether an area stays whole: it must where it is too short to divide, and may where it is no hall. */
function isRoom({ width, height }: Area, random: Random): boolean {
  const longest = Math.max(width, height);
  if (longest < 2 * LEAST) return true;
  return longest <= MOST && random.below(100) < WHOLE_PERCENT;
}

/** Divides an area across its longer side. */
function divide(grid: CellRows, area: Area, random: Random): Area[] {
  const isWide = area.width === area.height ? random.below(2) === 0 : area.width > area.height;
  const length = isWide ? area.width : area.height;
  const hasCorridor = length >= CORRIDOR_FROM && random.below(100) < CORRIDOR_PERCENT;
  const gap = hasCorridor ? 1 : 0;
  const first = LEAST + random.below(length - 2 * LEAST - gap + 1);
  wall(grid, area, isWide, first, random);
  if (hasCorridor) wall(grid, area, isWide, first + gap, random);
  const rest = length - first - gap;
  return isWide
    ? [
        { ...area, width: first },
        { ...area, left: area.left + first + gap, width: rest },
      ]
    : [
        { ...area, height: first },
        { ...area, top: area.top + first + gap, height: rest },
      ];
}

/** A wall with one door behind the first so many lattice cells of an area. */
function wall(grid: CellRows, area: Area, isWide: boolean, behind: number, random: Random): void {
  const across = isWide ? area.height : area.width;
  const along = 2 * ((isWide ? area.left : area.top) + behind);
  const from = 2 * (isWide ? area.top : area.left) + 1;
  const door = from + 2 * random.below(across);
  for (let at = from; at < from + 2 * across - 1; at += 1) {
    const [column, row] = isWide ? [along, at] : [at, along];
    const cells = grid[row];
    if (cells !== undefined && at !== door) cells[column] = BLOCK;
  }
}
