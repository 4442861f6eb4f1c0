/**
 * Shared by the parsers of drawn mazes: the meaning of each mark, and a sketch that collects the
 * start, the goals and the problems of a drawing.
 */
import type { FieldProblem, ReadResult } from "@corridor/protocol";
import type { Cell, MazeDocument } from "./maze-document.ts";
import { BLOCK, type HeadingName, headingNames, MAX_GOALS } from "./maze-limits.ts";

/** The lines of a drawing, without leading and trailing empty lines. */
export interface Drawing {
  lines: readonly string[];
  /** line number of the first line in the whole text, starting at 1 */
  firstLine: number;
}

/** The parts of a maze document that a drawing contains. */
export type DrawnMaze = Pick<MazeDocument, "blocks" | "start" | "goals">;

/** Meaning of a character. `heading` is null if the mark of the start has no heading. */
export type Mark =
  | { kind: "block" }
  | { kind: "open" }
  | { kind: "goal" }
  | { kind: "start"; heading: HeadingName | null; isGoal: boolean };

/** Marks of the start by heading, and of a start that is also a goal. */
export const startMarks: Record<HeadingName, { start: string; startAndGoal: string }> = {
  north: { start: "^", startAndGoal: "▲" },
  east: { start: ">", startAndGoal: "►" },
  south: { start: "v", startAndGoal: "▼" },
  west: { start: "<", startAndGoal: "◄" },
};
export const GOAL_MARK = "G";

const marks = new Map<string, Mark>();
for (const character of "#Xx█") marks.set(character, { kind: "block" });
for (const character of "._ ") marks.set(character, { kind: "open" });
for (const character of `${GOAL_MARK}g*`) marks.set(character, { kind: "goal" });
for (const character of "Ss") marks.set(character, { kind: "start", heading: null, isGoal: false });
for (const heading of headingNames) {
  const { start, startAndGoal } = startMarks[heading];
  marks.set(start, { kind: "start", heading, isGoal: false });
  marks.set(startAndGoal, { kind: "start", heading, isGoal: true });
}

/** Returns the meaning of a character, or undefined if it is not a mark. */
export function markOf(character: string): Mark | undefined {
  return marks.get(character);
}

/** Maximum number of reported problems. */
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
  #start: { cell: Cell; heading: HeadingName | null; position: string } | null = null;

  /** @param firstLine line number of the drawing's first line in its text, starting at 1 */
  constructor(firstLine: number) {
    this.#firstLine = firstLine;
  }

  /** Whether the maximum number of problems is reached. */
  get isFull(): boolean {
    return this.#problems.length >= MAX_PROBLEMS;
  }

  get hasProblems(): boolean {
    return this.#problems.length > 0;
  }

  /**
   * Adds a problem. Ignored if `isFull`.
   * @param line index in the drawing, from 0
   * @param column index in the line of text, from 0; null for the whole line
   */
  addProblem(line: number, column: number | null, found: string, expected: string): void {
    if (!this.isFull) this.#problems.push({ path: this.#position(line, column), found, expected });
  }

  /**
   * Adds a start or a goal, and a problem for a second start or one goal too many.
   * @param cell the cell in the maze
   * @param line index of the mark's line in the drawing
   * @param column index of the mark in its line of text
   */
  addMark(mark: Mark, cell: Cell, line: number, column: number): void {
    if (mark.kind === "goal" || (mark.kind === "start" && mark.isGoal)) {
      if (this.#goals.length === MAX_GOALS) {
        this.addProblem(line, column, "one more goal", `at most ${MAX_GOALS} goals`);
      } else this.#goals.push(cell);
    }
    if (mark.kind !== "start") return;
    if (this.#start === null) {
      this.#start = { cell, heading: mark.heading, position: this.#position(line, column) };
    } else {
      const expected = `one start in all; the first is in ${this.#start.position}`;
      this.addProblem(line, column, "a second start", expected);
    }
  }

  /**
   * Returns the maze, or the problems. Call it after the last line.
   * @param missing the start and the goals of a drawing that has none
   */
  finish(blocks: string[], missing?: Pick<DrawnMaze, "start" | "goals">): ReadResult<DrawnMaze> {
    const goals = this.#goals.length === 0 && missing !== undefined ? missing.goals : this.#goals;
    if (this.#start === null && this.#problems.length === 0) {
      if (missing !== undefined) return { ok: true, value: { ...missing, blocks, goals } };
      const expected = "one S, or one of ^ > v < for a start with a heading";
      return { ok: false, problems: [{ path: "start", found: "none", expected }] };
    }
    if (this.#start === null || this.#problems.length > 0) {
      return { ok: false, problems: this.#problems };
    }
    const { cell, heading } = this.#start;
    const start = { ...cell, heading: heading ?? firstOpenHeading(blocks, cell) };
    return { ok: true, value: { blocks, start, goals } };
  }

  #position(line: number, column: number | null): string {
    const position = `line ${line + this.#firstLine}`;
    return column === null ? position : `${position}, column ${column + 1}`;
  }
}

/** Heading for a start without one: the first open direction of north, east, south and west. */
export function firstOpenHeading(blocks: readonly string[], { column, row }: Cell): HeadingName {
  const firstOpen = headingNames.find((heading) => {
    const [right, down] = steps[heading];
    return (blocks[row + down]?.[column + right] ?? BLOCK) !== BLOCK;
  });
  return firstOpen ?? "north";
}

/** Common indentation of all non-empty lines, in characters. It is not part of the drawing. */
export function indentOf(lines: readonly string[]): number {
  let least = Number.POSITIVE_INFINITY;
  for (const line of lines) if (line.trim() !== "") least = Math.min(least, line.search(/\S/));
  return least;
}

/** Formats one or more characters for a problem. */
export function nameOf(text: string): string {
  if (text === " ") return "a space";
  if (text === "\t") return "a tab";
  return text === "" ? "nothing" : JSON.stringify(text);
}
