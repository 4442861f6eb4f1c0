/**
 * The open projects after the missions. None has a single correct answer, and the device stores the
 * best result. Never change an id: stored results, addresses and texts refer to it.
 */
import { mazePresets } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import type { Idea } from "./ideas.ts";
import { allEdits, eastFrom, lines, programOf, room, type Mission } from "./mission.ts";

export const projectIds = ["all-mazes", "fewest-bumps", "beat-right-wall"] as const;
export type ProjectId = (typeof projectIds)[number];

export interface Project {
  id: ProjectId;
  challenge: Mission["challenge"];
}

/** Simulated seconds for a program in each maze. */
export const PROJECT_SECONDS = 300;

/** The project with this id; null for a mission and for an unknown id. */
export function projectOf(id: string | null): ProjectId | null {
  return projectIds.find((each) => each === id) ?? null;
}

const rightWall = programPresets.find(({ id }) => id === "right-wall");
const handMaze = room(
  [
    "#############",
    "#...........#",
    "###.#######.#",
    "#...#...#...#",
    "#.#.#.#.#.###",
    "#...#.#...#.#",
    "#.#.#.#####.#",
    "#.#.........#",
    "#############",
  ],
  eastFrom(1, 1),
  { column: 11, row: 5 },
);
const openRoom = room(
  ["#########", "#.......#", "#.......#", "#.......#", "#########"],
  eastFrom(1, 3),
  { column: 7, row: 1 },
);

export const projects: readonly Project[] = [
  {
    id: "all-mazes",
    challenge: {
      mazes: mazePresets.filter(({ maze }) => maze.goals.length > 0).map(({ maze }) => maze),
      program: lines("forward"),
      goal: { kind: "reach" },
      allowed: programOf(4, ...allEdits),
      checks: { bumps: null, seconds: PROJECT_SECONDS },
      par: null,
    },
  },
  {
    id: "fewest-bumps",
    challenge: {
      mazes: [handMaze],
      program: lines("forward"),
      goal: { kind: "reach" },
      allowed: {
        drivers: ["me"],
        lines: 0,
        conditions: null,
        actions: null,
        edits: [],
        maze: false,
      },
      checks: { bumps: null, seconds: 600 },
      par: null,
    },
  },
  {
    id: "beat-right-wall",
    challenge: {
      mazes: [openRoom],
      program: rightWall?.program ?? null,
      // The program must not reach the goal, so reaching it meets nothing here.
      goal: { kind: "last", seconds: PROJECT_SECONDS },
      allowed: { ...programOf(2), maze: true },
      checks: { bumps: null, seconds: PROJECT_SECONDS },
      par: null,
    },
  },
];

/** Ideas of the thumbnails, one for each maze. */
export const projectIdeas: Readonly<Record<ProjectId, readonly Idea[]>> = {
  "all-mazes": [0, 1, 2].map(() => ({ robot: null, marks: [] })),
  "fewest-bumps": [
    {
      robot: null,
      marks: [
        {
          kind: "path",
          points: [
            [1.5, 1.5],
            [11.5, 1.5],
            [11.5, 3.5],
            [9.5, 3.5],
            [9.5, 4.4],
          ],
        },
        { kind: "bump", at: [12, 1.5] },
      ],
    },
  ],
  "beat-right-wall": [
    {
      robot: null,
      marks: [
        {
          kind: "path",
          points: [
            [1.5, 3.5],
            [7.5, 3.5],
            [7.5, 1.5],
            [1.5, 1.5],
            [1.5, 2.4],
          ],
        },
        { kind: "badge", at: [4.5, 2.5], text: "?", tone: "live" },
      ],
    },
  ],
};
