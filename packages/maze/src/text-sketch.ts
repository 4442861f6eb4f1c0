/**
 * What the readers of drawn mazes share: the meaning of a mark, and a sketch that collects start, goals
 * and problems until the whole drawing was looked at.
 */
import type { FieldProblem, ReadResult } from "@corridor/protocol";
import type { Cell, MazeDocument } from "./maze-document.ts";
import { BLOCK, type HeadingName, headingNames, MAX_GOALS } from "./maze-limits.ts";

/** The lines of a drawing without empty ones around it. */
export interface Drawing {
  lines: readonly string[];
  /** number of the first line in the whole text, counted from 1 */
  firstLine: number;
}

/** What a drawing says of a maze. */
export type DrawnMaze = Pick<MazeDocument, "blocks" | "start" | "goals">;

/** What a character stands for. The heading of a start is null where its mark does not tell it. */
export type Mark =
  | { kind: "block" }
  | { kind: "open" }
  | { kind: "goal" }
  | { kind: "start"; heading: HeadingName | null; isGoal: boolean };

/** Marks of a start by its heading, and of a start that is a goal too. */
export const startMarks: Record<HeadingName, { start: string; startAndGoal: string }> = {
  north: { start: "^", startAndGoal: "▲" },
  east: { start: ">", startAndGoal: "►" },
  south: { start: "v", startAndGoal: "▼" },
  west: { start: "<", startAndGoal: "◄" },
};
export const GOAL_MARK = "G";

const marks = new Map<string, Mark>();
for (const sign of "#Xx█") marks.set(sign, { kind: "block" });
for (const sign of "._ ") marks.set(sign, { kind: "open" });
for (const sign of `${GOAL_MARK}g*`) marks.set(sign, { kind: "goal" });
for (const sign of "Ss") marks.set(sign, { kind: "start", heading: null, isGoal: false });
for (const heading of headingNames) {
  const { start, startAndGoal } = startMarks[heading];
  marks.set(start, { kind: "start", heading, isGoal: false });
  marks.set(startAndGoal, { kind: "start", heading, isGoal: true });
}

/** What a character stands for; undefined where it stands for nothing. */
export function markOf(sign: string): Mark | undefined {
  return marks.get(sign);
}

/** No more problems than this are listed; the rest is looked at when these are mended. */
const MAX_PROBLEMS = 20;

const steps: Record<HeadingName, readonly [number, number]> = {
  north: [0, -1],
  east: [1, 0],
  south: [0, 1],
  west: [-1, 0],
};

export class Sketch {
  readonly #firstLine: number;
  readonly #problems: FieldProblem[] = [];
  readonly #goals: Cell[] = [];
  #start: { cell: Cell; heading: HeadingName | null; place: string } | null = null;

  /** @param firstLine number of the drawing's first line in its text, counted from 1 */
  constructor(firstLine: number) {
    this.#firstLine = firstLine;
  }

  /** Whether another problem would not be listed any more. */
  get isFull(): boolean {
    return this.#problems.length >= MAX_PROBLEMS;
  }

  /**
   * Notes a problem.
   * @param line counted from 0 in the drawing
   * @param column counted from 0 in the text's line; null where the whole line is meant
   */
  refuse(line: number, column: number | null, found: string, expected: string): void {
    if (!this.isFull) this.#problems.push({ path: this.#place(line, column), found, expected });
  }

  /** Takes a start or a goal, which stands at a cell of the maze and at a place in the text. */
  take(mark: Mark, cell: Cell, line: number, column: number): void {
    if (mark.kind === "goal" || (mark.kind === "start" && mark.isGoal)) {
      if (this.#goals.length === MAX_GOALS) {
        this.refuse(line, column, "one more goal", `at most ${MAX_GOALS} goals`);
      } else this.#goals.push(cell);
    }
    if (mark.kind !== "start") return;
    if (this.#start === null) {
      this.#start = { cell, heading: mark.heading, place: this.#place(line, column) };
    } else {
      const expected = `one start in all; the first is in ${this.#start.place}`;
      this.refuse(line, column, "a second start", expected);
    }
  }

  /** The maze, once every line was looked at. */
  finish(blocks: string[]): ReadResult<DrawnMaze> {
    if (this.#start === null && this.#problems.length === 0) {
      const expected = "one S, or one of ^ > v < for the way that the robot faces";
      return { ok: false, problems: [{ path: "start", found: "none", expected }] };
    }
    if (this.#start === null || this.#problems.length > 0) {
      return { ok: false, problems: this.#problems };
    }
    const { cell, heading } = this.#start;
    const start = { ...cell, heading: heading ?? firstWay(blocks, cell) };
    return { ok: true, value: { blocks, start, goals: this.#goals } };
  }

  #place(line: number, column: number | null): string {
    const place = `line ${line + this.#firstLine}`;
    return column === null ? place : `${place}, column ${column + 1}`;
  }
}

/** Where a start that does not say it faces: the first open way of north, east, south and west. */
function firstWay(blocks: readonly string[], { column, row }: Cell): HeadingName {
  const way = headingNames.find((heading) => {
    const [right, down] = steps[heading];
    return (blocks[row + down]?.[column + right] ?? BLOCK) !== BLOCK;
  });
  return way ?? "north";
}

/** Characters that all lines but empty ones have in front, at most; they belong to the page around the drawing. */
export function indentOf(lines: readonly string[]): number {
  let least = Number.POSITIVE_INFINITY;
  for (const line of lines) if (line.trim() !== "") least = Math.min(least, line.search(/\S/));
  return least;
}

/** A character or a few as a problem names them. */
export function nameOf(text: string): string {
  if (text === " ") return "a space";
  if (text === "\t") return "a tab";
  return text === "" ? "nothing" : JSON.stringify(text);
}
