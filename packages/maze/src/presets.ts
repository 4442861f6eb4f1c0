/**
 * Preset mazes, from easy to hard, as editable rows.
 * Never change an id: saved projects, tests and the page's translations refer to it.
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

/** All preset mazes, in menu order. */
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
  // A row of dead ends.
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
  // The output of generateTree({ columns: 15, rows: 15, seed: 1 }).
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
  // Open at its edges, with a cycle around the block at (7, 1).
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
  // For new mazes.
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
