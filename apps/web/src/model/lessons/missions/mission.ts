/**
 * A mission: a challenge document whose name and texts come from the translation catalogue. The
 * helpers make the mission data readable.
 */
import type { ChallengeDocument, ChallengeWords, EditKind } from "@corridor/challenge";
import type { Cell, MazeDocument, Start } from "@corridor/maze";
import type { ProgramDocument, Rule } from "@corridor/program";
import type { PlainAction } from "@corridor/protocol";

/** The missions in their order. Never change an id: stored progress and texts refer to it. */
export const missionIds = [
  "make-it-move",
  "how-far",
  "one-line",
  "first-true-line",
  "centimetres",
  "own-line",
  "side-opening",
  "no-room",
  "order-of-lines",
  "faulty-line",
  "right-wall",
  "every-maze",
  "left-or-right",
  "farthest-distance",
] as const;
export type MissionId = (typeof missionIds)[number];

/** A challenge without its texts. Its mazes take the name of the mission. */
export interface Mission {
  id: MissionId;
  challenge: Omit<ChallengeDocument, "format" | "version" | "name" | "words">;
}

/** The next mission; null after the last one, and if the id is not a mission. */
export function nextMission(id: string | null): MissionId | null {
  const at = missionIds.findIndex((each) => each === id);
  return at < 0 ? null : (missionIds[at + 1] ?? null);
}

/** The complete document in one language. */
export function challengeOf(
  { challenge }: Pick<Mission, "challenge">,
  name: string,
  words: ChallengeWords,
): ChallengeDocument {
  const { mazes, program } = challenge;
  return {
    ...challenge,
    format: "corridor/challenge",
    version: 1,
    name,
    words,
    mazes: mazes.map((maze) => ({ ...maze, name })),
    program: program && { ...program, name },
  };
}

/** A maze of the lessons. `challengeOf` adds its name. */
export function room(blocks: string[], start: Start, ...goals: Cell[]): MazeDocument {
  return { format: "corridor/maze", version: 1, name: "", blocks, start, goals };
}

/** A start that faces east, as in most missions. */
export function eastFrom(column: number, row: number): Start {
  return { column, row, heading: "east" };
}

/** A program of the lessons. `challengeOf` adds its name. */
export function lines(byDefault: PlainAction, ...rules: Rule[]): ProgramDocument {
  return { format: "corridor/program", version: 1, name: "", default: byDefault, rules };
}

/**
 * Permissions of a mission for which the student writes a program: at most `most` lines, and these
 * edits.
 */
export function programOf(most: number, ...edits: EditKind[]): Mission["challenge"]["allowed"] {
  return { drivers: ["program"], lines: most, conditions: null, actions: null, edits, maze: false };
}

/** All edits, for missions that start with an empty program. */
export const allEdits: EditKind[] = [
  "condition",
  "number",
  "action",
  "otherwise",
  "order",
  "lines",
];
