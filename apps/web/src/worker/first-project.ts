/**
 * What a reader sees who has never been here: a maze that the given program solves. The page and the
 * worker both have it, since on a first visit the worker begins before the page's script is there.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";

export interface FirstProject {
  maze: MazeDocument;
  program: ProgramDocument;
}

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
  name: "Example: right wall",
  default: "forward",
  rules: [
    { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
    { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
  ],
};

/** Both with their names in the reader's language. */
export function firstProject(mazeName: string, programName: string): FirstProject {
  return {
    maze: { ...firstMaze, name: mazeName },
    program: { ...firstProgram, name: programName },
  };
}

/**
 * What the worker begins with by itself.
 * @param name of the worker, as `public/first.js` gives it: on a first visit the names of both documents
 */
export function earlyWork(name: string): FirstProject | null {
  if (name === "") return null;
  const [mazeName, programName] = JSON.parse(name) as [string, string];
  return firstProject(mazeName, programName);
}
