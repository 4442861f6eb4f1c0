import type { LessonDocument } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";

/** What can be printed: a maze, or the mazes of a lesson with their tasks. */
export interface PrintedContent {
  /** of the teacher's texts; null: that of the page */
  language: string | null;
  mazes: readonly PrintedMaze[];
  /** for the QR code; null without one */
  link: string | null;
}

export interface PrintedMaze {
  maze: MazeDocument;
  /** heading of the worksheet; may be empty */
  name: string;
  task: string;
  /** most lines of a program, without "otherwise"; null: any number */
  lines: number | null;
}

/** All given mazes of a lesson, each with its task. */
export function printedMazes({ tasks }: LessonDocument): PrintedMaze[] {
  return tasks.flatMap(({ name, words, mazes, allowed }) =>
    mazes.map((maze) => ({ maze, name, task: words.task, lines: allowed.lines })),
  );
}

/** Longest address, in characters, for a QR code that a camera reads on paper. */
const MAX_PRINTED_LINK = 250;

/** @returns the first address that is short enough for paper, or null */
export function printedLink(...addresses: readonly (string | null)[]): string | null {
  return addresses.find((each) => each !== null && each.length <= MAX_PRINTED_LINK) ?? null;
}
