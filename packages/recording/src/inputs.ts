/**
 * The inputs of a run in the order of their ticks.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument, Rule } from "@corridor/program";
import type { RunInput, TimedInput } from "./run-input.ts";

/** What a robot runs in and by. */
export interface Documents {
  maze: MazeDocument;
  program: ProgramDocument;
}

/** Bytes of an input beside lines and rows, of one of an edit's places for these, and of a line, roughly. */
const INPUT_BYTES = 400;
const PLACE_BYTES = 8;
const RULE_BYTES = 160;

export class Inputs {
  readonly #inputs: TimedInput[] = [];
  #revision = 0;
  #generation = 0;

  get length(): number {
    return this.#inputs.length;
  }

  /** Rises with each change. */
  get revision(): number {
    return this.#revision;
  }

  /** Rises when inputs are removed or the start changes: until then, inputs only follow the ones before. */
  get generation(): number {
    return this.#generation;
  }

  at(index: number): TimedInput | undefined {
    return this.#inputs[index];
  }

  /** What the run began with is another: documents written before are out of date. */
  invalidate(): void {
    this.#revision++;
    this.#generation++;
  }

  add(tick: number, input: RunInput): void {
    this.#revision++;
    this.#inputs.push({ tick, ...input });
  }

  /**
   * Takes back the edits that stand at the end, from an index on, all but those of a kind.
   * @returns those that were left
   */
  dropEdits(from: number, kind: "program" | "maze"): TimedInput[] {
    const left = this.#inputs.slice(from).filter((input) => input.do !== kind);
    this.#generation++;
    this.#inputs.length = from;
    this.#inputs.push(...left);
    return left;
  }

  /** Index of the first input at or after a tick. */
  indexAt(tick: number): number {
    let low = 0;
    let high = this.#inputs.length;
    while (low < high) {
      const middle = (low + high) >>> 1;
      if ((this.#inputs[middle]?.tick ?? Infinity) < tick) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  truncateAfter(tick: number): void {
    this.#revision++;
    this.#generation++;
    this.#inputs.length = this.indexAt(tick + 1);
  }

  /** Bytes held, roughly. @param first the documents before the first input */
  byteLength({ maze, program }: Documents): number {
    let bytes = 0;
    for (const input of this.#inputs) {
      bytes += INPUT_BYTES;
      if (input.do === "maze") {
        bytes += ownBytes(input.maze.blocks, maze.blocks, (row) => row.length);
        maze = input.maze;
      }
      if (input.do === "program") {
        bytes += ownBytes(input.program.rules, program.rules, () => RULE_BYTES);
        program = input.program;
      }
    }
    return bytes;
  }

  /** @param from index of the first one */
  list(from = 0): TimedInput[] {
    return this.#inputs.slice(from);
  }
}

/**
 * The input, with each line or row that an edit leaves alone taken from the documents before it: a
 * thousand edits of a long program are not a thousand long programs in memory.
 */
export function shareUnchanged(input: RunInput, before: Documents): RunInput {
  if (input.do === "program") {
    const rules = input.program.rules.map((rule, index) => {
      const same = before.program.rules[index];
      return same !== undefined && isSameRule(same, rule) ? same : rule;
    });
    return { do: "program", program: { ...input.program, rules } };
  }
  if (input.do === "maze") {
    const blocks = input.maze.blocks.map((row, index) => {
      const same = before.maze.blocks[index];
      // Equal texts, but one copy of it in memory.
      return same === row ? same : row;
    });
    return { do: "maze", maze: { ...input.maze, blocks } };
  }
  return input;
}

/** Bytes of the parts of a document that it does not share with the one before. */
function ownBytes<Part>(
  parts: readonly Part[],
  before: readonly Part[],
  bytesOf: (part: Part) => number,
): number {
  let bytes = parts.length * PLACE_BYTES;
  for (const [index, part] of parts.entries()) if (part !== before[index]) bytes += bytesOf(part);
  return bytes;
}

function isSameRule(one: Rule, other: Rule): boolean {
  return JSON.stringify(one) === JSON.stringify(other);
}
