/**
 * The project of a first visit: a maze and a program that solves it. Page and worker both have it,
 * because on a first visit the worker starts before the page's script has loaded.
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

/** Both with translated names. */
export function firstProject(mazeName: string, programName: string): FirstProject {
  return {
    maze: { ...firstMaze, name: mazeName },
    program: { ...firstProgram, name: programName },
  };
}

/** Name of a worker that stores no run on the device. */
export const VOLATILE = "volatile";

/**
 * The project with which the worker starts before the page.
 * @param name name of the worker, from `public/first.js`: on a first visit the names of both
 *   documents
 */
export function earlyProject(name: string): FirstProject | null {
  if (name === "" || name === VOLATILE) return null;
  const [mazeName, programName] = JSON.parse(name) as [string, string];
  return firstProject(mazeName, programName);
}
