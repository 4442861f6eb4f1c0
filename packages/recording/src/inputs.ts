/** The inputs of a run, in tick order. */
import type { MazeDocument } from "@corridor/maze";
import { isSameRule, type ProgramDocument } from "@corridor/program";
import type { RunInput, TimedInput } from "./run-input.ts";

/** The current maze and program of a run. */
export interface Documents {
  maze: MazeDocument;
  program: ProgramDocument;
}

/** Approximate sizes in bytes: an input without rules and rows, a reference to one, and a rule. */
const INPUT_BYTES = 400;
const REFERENCE_BYTES = 8;
const RULE_BYTES = 160;

export class Inputs {
  readonly #inputs: TimedInput[] = [];
  #revision = 0;
  #generation = 0;

  get length(): number {
    return this.#inputs.length;
  }

  /** Increases with each change. */
  get revision(): number {
    return this.#revision;
  }

  /**
   * Increases when inputs are removed or the start changes. Within a generation, inputs only
   * append.
   */
  get generation(): number {
    return this.#generation;
  }

  at(index: number): TimedInput | undefined {
    return this.#inputs[index];
  }

  /** Marks earlier documents as out of date after a change of the start. */
  invalidate(): void {
    this.#revision++;
    this.#generation++;
  }

  add(tick: number, input: RunInput): void {
    this.#revision++;
    this.#inputs.push({ tick, ...input });
  }

  /**
   * Removes the edits of one kind from an index to the end.
   * @returns the remaining inputs from that index on
   */
  dropEdits(from: number, kind: "program" | "maze"): TimedInput[] {
    const remaining = this.#inputs.slice(from).filter((input) => input.do !== kind);
    this.#generation++;
    this.#inputs.length = from;
    this.#inputs.push(...remaining);
    return remaining;
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

  /** Approximate memory use in bytes. The parameter is the documents before the first input. */
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

  /** @param from index of the first returned input */
  list(from = 0): TimedInput[] {
    return this.#inputs.slice(from);
  }
}

/**
 * Returns the input with unchanged rules and rows replaced by those of the previous documents, so
 * that a thousand edits of a long program do not need the memory of a thousand programs.
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
      // Equal strings: returning the earlier one frees the memory of the copy.
      return same === row ? same : row;
    });
    return { do: "maze", maze: { ...input.maze, blocks } };
  }
  return input;
}

/** Size of the parts of a document that it does not share with the previous one, in bytes. */
function ownBytes<Part>(
  parts: readonly Part[],
  before: readonly Part[],
  bytesOf: (part: Part) => number,
): number {
  let bytes = parts.length * REFERENCE_BYTES;
  for (const [index, part] of parts.entries()) if (part !== before[index]) bytes += bytesOf(part);
  return bytes;
}
