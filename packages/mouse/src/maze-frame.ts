/**
 * The maze as a micromouse program sees it: cells from (0, 0) in the bottom left corner, x to the
 * right and y upward, with thin walls between them. Places are counted in half steps: the middle of
 * cell (x, y) is (2x + 1, 2y + 1), and the border between two cells has an even number.
 *
 * - In a maze of posts and walls, a cell is 200 cm wide: the wall between two cells is a block.
 * - In any other maze, a cell is one open block, 100 cm wide. A border of blocks around the whole maze
 *   is its outer wall.
 *
 * The start in any corner is (0, 0): the maze is turned by quarters until that corner is at the
 * bottom left. With another start, the bottom left corner of the maze is (0, 0).
 */
import { CELL, isBlock, sizeOf, type MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";

export interface Place {
  x: number;
  y: number;
}

/** Distance from the middle of a cell to its wall in cm, in every maze. */
const TO_WALL = 50;

export class MazeFrame {
  /** size as the program sees it, in cells */
  readonly columns: number;
  readonly rows: number;
  /** cm */
  readonly halfStep: number;
  /** Whether the robot starts in cell (0, 0). */
  readonly startsInCorner: boolean;
  /** size before the maze is turned, in half steps */
  readonly #width: number;
  readonly #height: number;
  /** cm from the edge of the grid to the middle of the outer wall */
  readonly #origin: number;
  /** clockwise quarters from the maze's north to the program's north */
  readonly #quarters: number;

  constructor(maze: MazeDocument) {
    const { columns, rows } = sizeOf(maze);
    const hasBorder = isBordered(maze);
    if (hasBorder && hasPosts(maze)) {
      this.halfStep = CELL;
      this.#origin = CELL / 2;
      this.#width = columns - 1;
      this.#height = rows - 1;
    } else {
      this.halfStep = CELL / 2;
      this.#origin = hasBorder ? CELL : 0;
      this.#width = 2 * (hasBorder ? columns - 2 : columns);
      this.#height = 2 * (hasBorder ? rows - 2 : rows);
    }
    const { x, y } = this.#mapPlaceOf(middleOf(maze.start));
    const corners = [
      { x: 1, y: 1 },
      { x: 1, y: this.#height - 1 },
      { x: this.#width - 1, y: this.#height - 1 },
      { x: this.#width - 1, y: 1 },
    ];
    const corner = corners.findIndex((each) => each.x === x && each.y === y);
    this.startsInCorner = corner >= 0;
    this.#quarters = Math.max(0, corner);
    const isOnItsSide = this.#quarters % 2 === 1;
    this.columns = (isOnItsSide ? this.#height : this.#width) / 2;
    this.rows = (isOnItsSide ? this.#width : this.#height) / 2;
  }

  /** Blocks of a cell along one side. */
  get pitch(): 1 | 2 {
    return this.halfStep === CELL ? 2 : 1;
  }

  /** The place nearest to a pose. */
  placeOf(pose: Pose): Place {
    const size = { width: this.#width, height: this.#height };
    return turned(this.#mapPlaceOf(pose), this.#quarters, size);
  }

  /** The direction nearest to a heading, in eighths of a full turn clockwise from the program's north. */
  eighthsOf(heading: number): number {
    return eighths(Math.round(heading / 45) - 2 * this.#quarters);
  }

  /** Half steps to the wall from which a sensor reads a distance, minus 1. */
  freeHalfSteps(reading: number): number {
    return Math.max(0, Math.round((reading - TO_WALL) / this.halfStep));
  }

  has({ x, y }: Place): boolean {
    return x >= 0 && x < this.columns && y >= 0 && y < this.rows;
  }

  /** Whether a cell is one of the 1, 2 or 4 cells in the centre. */
  isGoal({ x, y }: Place): boolean {
    const isMiddle = (at: number, size: number): boolean =>
      at === Math.floor(size / 2) || at === Math.floor((size - 1) / 2);
    return isMiddle(x, this.columns) && isMiddle(y, this.rows);
  }

  /** The block in the middle of a cell. */
  blockOf({ x, y }: Place): { column: number; row: number } {
    const size = { width: 2 * this.columns, height: 2 * this.rows };
    const middle = { x: 2 * x + 1, y: 2 * y + 1 };
    const place = turned(middle, (4 - this.#quarters) % 4, size);
    const index = (halfSteps: number): number =>
      Math.floor((this.#origin + halfSteps * this.halfStep) / CELL);
    return { column: index(place.x), row: index(this.#height - place.y) };
  }

  /** The side of the maze's cell that the program calls `side`, clockwise quarters from north. */
  mapSideOf(side: number): number {
    return (side + this.#quarters) % 4;
  }

  /** A place in the maze with north at its top. */
  #mapPlaceOf({ x, y }: { x: number; y: number }): Place {
    const halfSteps = (at: number): number => Math.round((at - this.#origin) / this.halfStep);
    return { x: halfSteps(x), y: this.#height - halfSteps(y) };
  }
}

/** The same place in a maze that is turned counter-clockwise. */
function turned(place: Place, quarters: number, size: { width: number; height: number }): Place {
  let { x, y } = place;
  let { width, height } = size;
  for (let quarter = 0; quarter < quarters; quarter += 1) {
    [x, y] = [height - y, x];
    [width, height] = [height, width];
  }
  return { x, y };
}

/** An eighth from 0 to 7. */
export function eighths(turned: number): number {
  return ((turned % 8) + 8) % 8;
}

function middleOf({ column, row }: { column: number; row: number }): { x: number; y: number } {
  return { x: (column + 0.5) * CELL, y: (row + 0.5) * CELL };
}

/** Whether all blocks at the edge of the grid are solid, and others are inside. */
function isBordered(maze: MazeDocument): boolean {
  const { columns, rows } = sizeOf(maze);
  if (columns < 3 || rows < 3) return false;
  return everyBlock(maze, (column, row) => {
    const isEdge = column === 0 || row === 0 || column === columns - 1 || row === rows - 1;
    return !isEdge || isBlock(maze, column, row);
  });
}

/** Whether posts stand in every second row and column, with open cells between them. */
function hasPosts(maze: MazeDocument): boolean {
  const { columns, rows } = sizeOf(maze);
  if (columns % 2 === 0 || rows % 2 === 0) return false;
  return everyBlock(maze, (column, row) => {
    if (column % 2 !== row % 2) return true;
    return isBlock(maze, column, row) === (column % 2 === 0);
  });
}

function everyBlock(maze: MazeDocument, holds: (column: number, row: number) => boolean): boolean {
  const { columns, rows } = sizeOf(maze);
  for (let row = 0; row < rows; row += 1) {
    for (let column = 0; column < columns; column += 1) if (!holds(column, row)) return false;
  }
  return true;
}
