/** Codes a program as bits, with one function for encoding and decoding: default, rules, name. */
import {
  conditionKinds,
  conditionOf,
  kindOf,
  MAX_NAME_LENGTH,
  MAX_RULES,
  numberOf,
  type Condition,
  type ProgramDocument,
} from "@corridor/program";
import { plainActions } from "@corridor/protocol";
import { codeName } from "./name-coder.ts";
import { NumberModel, RealModel, SymbolModel } from "./numbers.ts";
import type { BitCoder } from "./range-coder.ts";

/** Symbols of conditions: 0 is `[Do nothing]`, then the menu entries in order. */
const KIND_BITS = 4;
const ACTION_BITS = 3;

/**
 * Encodes or decodes a program.
 * @param program the program to encode; a decoder ignores it, and its caller passes any valid
 *   program
 * @returns the decoded program, not yet checked by its schema; null if the bits cannot come from an
 *   encoder
 */
export function codeProgram(
  coder: BitCoder,
  program: ProgramDocument,
  isPlainName: boolean,
): ProgramDocument | null {
  const lines = codeLines(coder, program);
  if (lines === null) return null;
  return { ...lines, name: codeName(coder, program.name, MAX_NAME_LENGTH, isPlainName) };
}

/**
 * Encodes or decodes a program without its name.
 * @returns as `codeProgram`, with an empty name
 */
export function codeLines(coder: BitCoder, program: ProgramDocument): ProgramDocument | null {
  const actions = new SymbolModel(ACTION_BITS);
  const codeAction = (action: (typeof plainActions)[number]) =>
    plainActions[actions.code(coder, plainActions.indexOf(action))];
  const conditions = new ConditionCoder();

  const byDefault = codeAction(program.default);
  if (byDefault === undefined) return null;
  const count = new NumberModel().code(coder, program.rules.length);
  if (count > MAX_RULES) return null;
  const rules: ProgramDocument["rules"] = [];
  for (let at = 0; at < count; at += 1) {
    const rule = program.rules[at] ?? { when: null, do: "forward" };
    const when = conditions.code(coder, rule.when);
    const action = codeAction(rule.do);
    if (when === undefined || action === undefined) return null;
    rules.push({ when, do: action });
  }
  return { format: "corridor/program", version: 1, name: "", default: byDefault, rules };
}

/** Codes conditions with adaptive models of their kinds and numbers. */
export class ConditionCoder {
  readonly #kinds = new SymbolModel(KIND_BITS);
  readonly #numbers = new RealModel();

  /** @returns undefined if the kind does not exist */
  code(coder: BitCoder, condition: Condition | null): Condition | null | undefined {
    const index = condition === null ? 0 : conditionKinds.indexOf(kindOf(condition)) + 1;
    const symbol = this.#kinds.code(coder, index);
    if (symbol === 0) return null;
    const kind = conditionKinds[symbol - 1];
    const number = this.#numbers.code(coder, condition === null ? 0 : numberOf(condition));
    return kind === undefined ? undefined : conditionOf(kind, number);
  }
}
