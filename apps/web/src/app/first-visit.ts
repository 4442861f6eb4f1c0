/** What a reader sees who has never been here: a maze that the given program solves. */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { i18n } from "i18next";

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

/** Both with their names in the reader's language. */
export function firstWork(words: Pick<i18n, "t">): {
  maze: MazeDocument;
  program: ProgramDocument;
} {
  return {
    maze: { ...firstMaze, name: words.t("presets.long-way-round.title") },
    program: { ...firstProgram, name: words.t("program.preset.right-wall.name") },
  };
}
