/**
 * A mission: a challenge document whose name and words come from the catalogue of the reader's
 * language. The helpers here keep the data beside them readable.
 */
import type { ChallengeDocument, ChallengeWords, EditKind } from "@corridor/challenge";
import type { Cell, MazeDocument, Start } from "@corridor/maze";
import type { ProgramDocument, Rule } from "@corridor/program";
import type { PlainAction } from "@corridor/protocol";

/** In the order of the path. The ids stay for ever: progress on devices and words refer to them. */
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

/** A challenge without its words. The mazes' names are those of the mission. */
export interface Mission {
  id: MissionId;
  challenge: Omit<ChallengeDocument, "format" | "version" | "name" | "words">;
}

/** The mission after one; null after the last, and for what is no mission. */
export function nextMission(id: string | null): MissionId | null {
  const at = missionIds.findIndex((each) => each === id);
  return at < 0 ? null : (missionIds[at + 1] ?? null);
}

/** The whole document in one language. */
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

/** A maze of the lessons; it gets its name with the mission's words. */
export function room(blocks: string[], start: Start, ...goals: Cell[]): MazeDocument {
  return { format: "corridor/maze", version: 1, name: "", blocks, start, goals };
}

/** A start that faces east, where most missions begin. */
export function eastFrom(column: number, row: number): Start {
  return { column, row, heading: "east" };
}

/** A program of the lessons; it gets its name with the mission's words. */
export function lines(byDefault: PlainAction, ...rules: Rule[]): ProgramDocument {
  return { format: "corridor/program", version: 1, name: "", default: byDefault, rules };
}

/** What is allowed where a program is to be written: its driver, so many lines, these edits. */
export function programOf(most: number, ...edits: EditKind[]): Mission["challenge"]["allowed"] {
  return { drivers: ["program"], lines: most, conditions: null, actions: null, edits, maze: false };
}

/** Everything that an empty program needs. */
export const allEdits: EditKind[] = [
  "condition",
  "number",
  "action",
  "otherwise",
  "order",
  "lines",
];
