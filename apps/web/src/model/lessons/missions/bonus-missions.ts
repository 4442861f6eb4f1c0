/**
 * The bonus missions after the fourteen missions. None has a single correct answer, and the device
 * stores the best result. Never change an id: stored results, addresses and texts refer to it.
 */
import { mazePresets } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import type { Idea } from "./ideas.ts";
import { allEdits, eastFrom, lines, programOf, room, type Mission } from "./mission.ts";

export const bonusMissionIds = ["all-mazes", "fewest-bumps", "beat-right-wall"] as const;
export type BonusMissionId = (typeof bonusMissionIds)[number];

export interface BonusMission {
  id: BonusMissionId;
  challenge: Mission["challenge"];
}

/** Simulated seconds for a program in each maze. */
export const BONUS_SECONDS = 300;

/** The id if it names a bonus mission; null for another mission and for an unknown id. */
export function bonusMissionOf(id: string | null): BonusMissionId | null {
  return bonusMissionIds.find((each) => each === id) ?? null;
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

export const bonusMissions: readonly BonusMission[] = [
  {
    id: "all-mazes",
    challenge: {
      mazes: mazePresets.filter(({ maze }) => maze.goals.length > 0).map(({ maze }) => maze),
      program: lines("forward"),
      goal: { kind: "reach" },
      allowed: programOf(4, ...allEdits),
      checks: { bumps: null, seconds: BONUS_SECONDS },
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
      goal: { kind: "last", seconds: BONUS_SECONDS },
      allowed: { ...programOf(2), maze: true },
      checks: { bumps: null, seconds: BONUS_SECONDS },
      par: null,
    },
  },
];

/** Ideas of the thumbnails, one for each maze. */
export const bonusMissionIdeas: Readonly<Record<BonusMissionId, readonly Idea[]>> = {
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
