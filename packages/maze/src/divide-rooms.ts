/**
 * Rectangular rooms connected by doors and, in larger mazes, by corridors, like a floor plan.
 * Recursive division: a wall with a door, or a corridor with a door on each side, divides an area
 * until each part is as small as a room. Walls are on even cells and doors on odd cells, so that no
 * later wall blocks a door.
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

/** Bounds of a room's sides in lattice cells, equal to 3 and 9 maze cells. */
const MIN_ROOM_SIDE = 2;
const MAX_ROOM_SIDE = 5;
/**
 * Minimum length of an area with a corridor, in lattice cells: two rooms, two walls, one corridor.
 */
const MIN_CORRIDOR_LENGTH = 2 * MIN_ROOM_SIDE + 3;
/**
 * Percentage of long enough areas that get a corridor, and of small enough areas that stay whole.
 */
const CORRIDOR_PERCENT = 40;
const WHOLE_PERCENT = 45;

/**
 * Divides the inside of a maze into rooms of at least 3 x 3 cells. All open cells are connected.
 * @param columns odd and at least 5, as `rows`
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

/**
 * Whether an area stays whole: always if it is too short to divide, at random if it is room-sized.
 */
function isRoom({ width, height }: Area, random: Random): boolean {
  const longest = Math.max(width, height);
  if (longest < 2 * MIN_ROOM_SIDE) return true;
  return longest <= MAX_ROOM_SIDE && random.below(100) < WHOLE_PERCENT;
}

/** Divides an area across its longer side. */
function divide(grid: CellRows, area: Area, random: Random): Area[] {
  const isWide = area.width === area.height ? random.below(2) === 0 : area.width > area.height;
  const length = isWide ? area.width : area.height;
  const hasCorridor = length >= MIN_CORRIDOR_LENGTH && random.below(100) < CORRIDOR_PERCENT;
  const gap = hasCorridor ? 1 : 0;
  const first = MIN_ROOM_SIDE + random.below(length - 2 * MIN_ROOM_SIDE - gap + 1);
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

/** Builds a wall with one door across an area, after its first `behind` lattice cells. */
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
