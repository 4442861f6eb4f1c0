/** Mazes of several kinds and any size, to test the lengths of their links. */
import { createRandom, type MazeDocument } from "@corridor/maze";

/** Creates a maze from rows. The start is the first open cell, the goal the last. */
function fromRows(name: string, blocks: string[]): MazeDocument {
  const columns = blocks[0]?.length ?? 0;
  const marks = blocks.join("");
  const cellAt = (at: number) => ({ column: at % columns, row: Math.floor(at / columns) });
  return {
    format: "corridor/maze",
    version: 1,
    name,
    blocks,
    start: { ...cellAt(marks.indexOf(".")), heading: "east" },
    goals: [cellAt(marks.lastIndexOf("."))],
  };
}

/**
 * Creates a maze in which each cell is a block with a probability in percent. The border is
 * optional.
 */
export function randomMaze(
  name: string,
  side: number,
  percent: number,
  hasBorder: boolean,
  seed: number,
): MazeDocument {
  const random = createRandom(seed);
  const isBorder = (at: number): boolean => hasBorder && (at === 0 || at === side - 1);
  const rows = Array.from({ length: side }, (_, row) =>
    Array.from({ length: side }, (__, column) =>
      isBorder(row) || isBorder(column) || random.below(100) < percent ? "#" : ".",
    ).join(""),
  );
  return fromRows(name, rows);
}

/**
 * Creates a maze with a border and forty straight strokes of 3 to 11 blocks, like a hand-drawn
 * maze.
 */
export function drawnMaze(name: string, side: number, seed: number): MazeDocument {
  const random = createRandom(seed);
  const grid = randomMaze(name, side, 0, true, seed).blocks.map((row) => row.split(""));
  for (let stroke = 0; stroke < 40; stroke += 1) {
    const [column, row] = [random.below(side), random.below(side)];
    const [isAcross, length] = [random.below(2) === 1, 3 + random.below(9)];
    for (let step = 0; step < length; step += 1) {
      const cells = grid[Math.min(side - 1, row + (isAcross ? 0 : step))];
      const at = Math.min(side - 1, column + (isAcross ? step : 0));
      if (cells !== undefined) cells[at] = "#";
    }
  }
  return fromRows(
    name,
    grid.map((row) => row.join("")),
  );
}

/**
 * Creates a perfect maze by Kruskal's algorithm, with shorter corridors than a depth-first search.
 */
export function bushyTree(name: string, side: number, seed: number): MazeDocument {
  const random = createRandom(seed);
  const grid = Array.from({ length: side }, (_, row) =>
    Array.from({ length: side }, (__, column) => (row % 2 === 1 && column % 2 === 1 ? "." : "#")),
  );
  const walls: { column: number; row: number }[] = [];
  for (let row = 1; row < side - 1; row += 1) {
    for (let column = 1; column < side - 1; column += 1) {
      if ((row + column) % 2 === 1) walls.push({ column, row });
    }
  }
  const sets = Array.from({ length: side * side }, (_, at) => at);
  while (walls.length > 0) {
    const wall = walls.splice(random.below(walls.length), 1)[0] ?? { column: 0, row: 0 };
    const at = wall.row * side + wall.column;
    const step = wall.row % 2 === 1 ? 1 : side;
    const [a, b] = [sets[at - step] ?? 0, sets[at + step] ?? 0];
    if (a === b) continue;
    for (const [cell, set] of sets.entries()) if (set === a) sets[cell] = b;
    const cells = grid[wall.row];
    if (cells !== undefined) cells[wall.column] = ".";
  }
  return fromRows(
    name,
    grid.map((row) => row.join("")),
  );
}
