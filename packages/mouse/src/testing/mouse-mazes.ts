/** Mazes for tests: the document that the robot drives in, and the grid of thin walls beside it. */
import { generateMaze, readTextMaze, type MazeDocument } from "@corridor/maze";
import { GridWorld } from "./grid-world.ts";

/** A drawing with posts and walls, as mms reads it: 4 characters and 2 lines a cell. */
export interface MouseMaze {
  name: string;
  drawing: string;
}

/** A grid from a drawing, north at the top. */
export function gridOfDrawing(drawing: string): GridWorld {
  const lines = drawing.split("\n").filter((line) => line.trim() !== "");
  const rows = (lines.length - 1) / 2;
  const columns = ((lines[0]?.length ?? 0) - 1) / 4;
  return new GridWorld(columns, rows, (x, y, side) => {
    const top = 2 * (rows - 1 - y);
    const at = [
      [top, 4 * x + 2],
      [top + 1, 4 * x + 4],
      [top + 2, 4 * x + 2],
      [top + 1, 4 * x],
    ] as const;
    const [line, column] = at[side] ?? [0, 0];
    return (lines[line]?.[column] ?? " ") !== " ";
  });
}

/** The document of a drawing, with the start at the bottom left and facing north. */
export function documentOf({ name, drawing }: MouseMaze): MazeDocument {
  const lines = drawing.split("\n").filter((line) => line.trim() !== "");
  const last = lines.length - 2;
  const marked = lines.map((line, at) =>
    at === last ? `${line.slice(0, 2)}^${line.slice(3)}` : line,
  );
  const read = readTextMaze(marked.join("\n"), name);
  if (!read.ok) throw new Error(JSON.stringify(read.problems));
  return read.value;
}

const headings = ["north", "east", "south", "west"] as const;

/** The maze turned clockwise by a quarter, with its start. */
export function turnedClockwise(maze: MazeDocument): MazeDocument {
  const height = maze.blocks.length;
  const width = maze.blocks[0]?.length ?? 0;
  const turnedCell = ({ column, row }: { column: number; row: number }) => ({
    column: height - 1 - row,
    row: column,
  });
  const blocks = Array.from({ length: width }, (_, column) =>
    Array.from({ length: height }, (_, at) => maze.blocks[height - 1 - at]?.[column] ?? "#").join(
      "",
    ),
  );
  const heading = headings[(headings.indexOf(maze.start.heading) + 1) % 4] ?? "north";
  return {
    ...maze,
    blocks,
    start: { ...turnedCell(maze.start), heading },
    goals: maze.goals.map(turnedCell),
  };
}

/** Draws a maze of posts and walls. */
export function drawingOf({ blocks }: MazeDocument): string {
  return blocks
    .map((row, at) =>
      Array.from(row, (block, column) => {
        const isBlock = block === "#";
        if (column % 2 === 0) return isBlock ? (at % 2 === 0 ? "o" : "|") : " ";
        return isBlock ? "---" : "   ";
      }).join(""),
    )
    .join("\n");
}

function generated(kind: "tree" | "loops", columns: number, rows: number, seed: number): MouseMaze {
  const maze = generateMaze({
    kind,
    columns: 2 * columns + 1,
    rows: 2 * rows + 1,
    seed,
    name: `${kind} ${columns} x ${rows}`,
  });
  return { name: maze.name, drawing: drawingOf(maze) };
}

/** Five mazes, in which a wall follower reaches the centre, too. */
export const mouseMazes: readonly MouseMaze[] = [
  {
    name: "drawn 6 x 6",
    drawing: `
o---o---o---o---o---o---o
|       |               |
o   o   o   o---o---o   o
|   |       |       |   |
o   o---o---o   o   o   o
|   |       |   |   |   |
o   o   o   o   o   o   o
|   |   |           |   |
o   o   o---o---o---o   o
|   |       |       |   |
o   o---o   o   o   o   o
|   |           |       |
o---o---o---o---o---o---o
`,
  },
  generated("tree", 5, 5, 3),
  generated("tree", 7, 4, 8),
  generated("loops", 8, 8, 8),
  generated("tree", 16, 16, 12),
];
