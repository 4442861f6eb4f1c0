/**
 * A program document compiled to flat tables, which are evaluated without allocation.
 * `[Do nothing]` lines are skipped. Indices refer to the document.
 */
import { sensorNames, type PlainAction } from "@corridor/protocol";
import type { ProgramDocument } from "./program-document.ts";

const RIGHT = sensorNames.indexOf("right");

export class CompiledProgram {
  readonly #count: number;
  /** document index of each condition */
  readonly #rules: Int32Array;
  readonly #sensors: Int32Array;
  readonly #isGreater: Uint8Array;
  readonly #numbers: Float64Array;
  /** 1 if the right reading is added to the number */
  readonly #addsRight: Uint8Array;
  /** commands by rule index + 1; the default command is at 0 */
  readonly #commands: readonly { action: PlainAction }[];

  constructor(program: ProgramDocument) {
    const active = program.rules.flatMap(({ when }, rule) => (when === null ? [] : { when, rule }));
    this.#count = active.length;
    this.#rules = Int32Array.from(active, ({ rule }) => rule);
    this.#sensors = Int32Array.from(active, ({ when }) => sensorNames.indexOf(when.sensor));
    this.#isGreater = Uint8Array.from(active, ({ when }) => (when.is === ">" ? 1 : 0));
    this.#numbers = Float64Array.from(active, ({ when }) =>
      when.than === "right" ? when.plus : when.than,
    );
    this.#addsRight = Uint8Array.from(active, ({ when }) => (when.than === "right" ? 1 : 0));
    const actions = [program.default, ...program.rules.map((rule) => rule.do)];
    this.#commands = actions.map((action) => ({ action }));
  }

  /**
   * Finds the first rule that is true for these readings.
   * @param readings front, right, back, left in units
   * @returns its index in the document, or -1 for the default if no rule is true
   */
  decide(readings: Float64Array): number {
    for (let i = 0; i < this.#count; i++) {
      const reading = readings[this.#sensors[i] ?? 0] ?? 0;
      const number = this.#numbers[i] ?? 0;
      const limit = this.#addsRight[i] === 1 ? (readings[RIGHT] ?? 0) + number : number;
      if (this.#isGreater[i] === 1 ? reading > limit : reading < limit) return this.#rules[i] ?? -1;
    }
    return -1;
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
