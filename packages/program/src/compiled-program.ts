/**
 * A program document compiled to flat tables, which are evaluated without allocation.
 * `[Do nothing]` lines are skipped. Indices refer to the document.
 */
import type { PlainAction } from "@corridor/protocol";
import { CompiledConditions } from "./compiled-conditions.ts";
import type { ProgramDocument } from "./program-document.ts";

export class CompiledProgram {
  readonly #conditions: CompiledConditions;
  /** document index of each condition */
  readonly #rules: Int32Array;
  /** commands by rule index + 1; the default command is at 0 */
  readonly #commands: readonly { action: PlainAction }[];

  constructor(program: ProgramDocument) {
    const active = program.rules.flatMap(({ when }, rule) => (when === null ? [] : { when, rule }));
    this.#conditions = new CompiledConditions(active.map(({ when }) => when));
    this.#rules = Int32Array.from(active, ({ rule }) => rule);
    const actions = [program.default, ...program.rules.map((rule) => rule.do)];
    this.#commands = actions.map((action) => ({ action }));
  }

  /**
   * Finds the first rule that is true for these readings.
   * @param readings front, right, back, left in units
   * @returns its index in the document, or -1 for the default if no rule is true
   */
  decide(readings: Float64Array): number {
    const found = this.#conditions.firstTrue(readings);
    return found < 0 ? -1 : (this.#rules[found] ?? -1);
  }

  /** Number of rules in the document, including `[Do nothing]`. */
  get ruleCount(): number {
    return this.#commands.length - 1;
  }

  /** Returns the command of a rule, or of the default for -1. Always returns the same object. */
  commandOf(rule: number): { action: PlainAction } {
    const command = this.#commands[rule + 1];
    if (command === undefined) throw new RangeError(`The program has no rule ${rule}.`);
    return command;
  }
}
