/** What a reader sees who has never been here: a maze that the given program solves. */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";

export const firstMaze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "Long way round",
  blocks: [
    "...#.....#.",
    ".#.#.#.#.#.",
    ".#...#...#.",
    ".#####.#.#.",
    ".....#.#...",
    "##.#.#.###.",
    "...#...#...",
  ],
  start: { column: 0, row: 6, heading: "east" },
  goals: [{ column: 10, row: 0 }],
};

export const firstProgram: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "Right wall",
  default: "forward",
  rules: [
    { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
    { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
  ],
};
