/**
 * Ready-made mazes, from easy to hard, written down as rows so that they can be read and changed here.
 * The ids stay for ever: saved works, tests and the page's words refer to them.
 */
import type { Cell, MazeDocument, Start } from "./maze-document.ts";

const mazePresetIds = [
  "first-steps",
  "straight-corridor",
  "spiral",
  "comb",
  "tree",
  "long-way-round",
  "two-rooms",
  "empty",
] as const;
export type MazePresetId = (typeof mazePresetIds)[number];

export interface MazePreset {
  id: MazePresetId;
  maze: MazeDocument;
}

function preset(
  id: MazePresetId,
  name: string,
  start: Start,
  goals: Cell[],
  blocks: string[],
): MazePreset {
  return { id, maze: { format: "corridor/maze", version: 1, name, blocks, start, goals } };
}

/** All mazes of the menu, in its order. */
export const mazePresets: readonly MazePreset[] = [
  // A corridor with one jog.
  preset(
    "first-steps",
    "First steps",
    { column: 1, row: 1, heading: "east" },
    [{ column: 7, row: 2 }],
    ["#########", "#....####", "####....#", "#########"],
  ),
  // For the program of Figure 19.
  preset(
    "straight-corridor",
    "Straight corridor",
    { column: 1, row: 1, heading: "east" },
    [{ column: 9, row: 1 }],
    ["###########", "#.........#", "###########"],
  ),
  // Right turns only.
  preset(
    "spiral",
    "Spiral",
    { column: 1, row: 1, heading: "east" },
    [{ column: 5, row: 5 }],
    [
      "###########",
      "#.........#",
      "#########.#",
      "#.......#.#",
      "#.#####.#.#",
      "#.#...#.#.#",
      "#.#.###.#.#",
      "#.#.....#.#",
      "#.#######.#",
      "#.........#",
      "###########",
    ],
  ),
  // One dead end after the other.
  preset(
    "comb",
    "Comb",
    { column: 1, row: 4, heading: "east" },
    [{ column: 11, row: 1 }],
    [
      "#############",
      "#.#.#.#.#.#.#",
      "#.#.#.#.#.#.#",
      "#.#.#.#.#.#.#",
      "#...........#",
      "#############",
    ],
  ),
  // generateTree({ columns: 15, rows: 15, seed: 1 }), written down.
  preset(
    "tree",
    "Tree",
    { column: 1, row: 1, heading: "east" },
    [{ column: 1, row: 13 }],
    [
      "###############",
      "#.....#...#...#",
      "#####.#.#.###.#",
      "#...#...#.....#",
      "#.###########.#",
      "#.....#.......#",
      "#.###.#.#######",
      "#...#.#.#.....#",
      "###.#.#.#.#####",
      "#...#.#.#.....#",
      "#.###.#.#####.#",
      "#...#.#.....#.#",
      "###.#.#####.#.#",
      "#...#.........#",
      "###############",
    ],
  ),
  // Open to its edges, with a loop round the block at (7, 1).
  preset(
    "long-way-round",
    "Long way round",
    { column: 0, row: 6, heading: "east" },
    [{ column: 10, row: 0 }],
    [
      "...#.....#.",
      ".#.#.#.#.#.",
      ".#...#...#.",
      ".#####.#.#.",
      ".....#.#...",
      "##.#.#.###.",
      "...#...#...",
    ],
  ),
  // Find the door in the wall between them.
  preset(
    "two-rooms",
    "Two rooms",
    { column: 0, row: 6, heading: "east" },
    [{ column: 10, row: 6 }],
    [
      ".....#.....",
      ".....#.....",
      "...........",
      ".....#.....",
      ".....#.....",
      ".....#.....",
      ".....#.....",
    ],
  ),
  // For mazes of one's own.
  preset(
    "empty",
    "Empty",
    { column: 0, row: 6, heading: "east" },
    [],
    [
      "...........",
      "...........",
      "...........",
      "...........",
      "...........",
      "...........",
      "...........",
    ],
  ),
];
