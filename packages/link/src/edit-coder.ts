/**
 * Codes edits of a maze or a program as differences from the previous document. A run can contain
 * many edits, most of which change one block or one number.
 */
import {
  BLOCK,
  headingNames,
  MAX_GOALS,
  MAX_SIDE,
  OPEN,
  sizeOf,
  type Cell,
  type MazeDocument,
} from "@corridor/maze";
import {
  isSameRule,
  MAX_NAME_LENGTH,
  MAX_RULES,
  type ProgramDocument,
  type Rule,
} from "@corridor/program";
import { plainActions, type PlainAction } from "@corridor/protocol";
import type { Choices } from "./choices.ts";
import { cellsOf, codeMaze } from "./maze-coder.ts";
import { codeName } from "./name-coder.ts";
import { codeUniform, NumberModel, SymbolModel } from "./numbers.ts";
import { ConditionCoder } from "./program-coder.ts";
import { BitModel, type BitCoder } from "./range-coder.ts";

/** Maximum number of changed cells. An edit of more cells is coded as a whole maze. */
const MAX_FLIPS = 256;

/** Codes edits of mazes. */
export class MazeEditCoder {
  readonly #choices: Choices;
  /** contexts: is it a whole maze, did the start change, did the goals change */
  readonly #bits = new BitModel(3, 4);
  readonly #counts = new NumberModel();
  readonly #distances = new NumberModel();

  constructor(choices: Choices) {
    this.#choices = choices;
  }

  /**
   * Encodes or decodes an edit.
   * @param after the maze to encode; a decoder ignores it, and its caller passes any valid maze
   * @returns the maze after the edit, not yet checked by its schema; null if the bits cannot come
   *   from an encoder
   */
  code(coder: BitCoder, before: MazeDocument, after: MazeDocument): MazeDocument | null {
    const flips = flipsBetween(before, after);
    const isWhole = this.#bits.code(coder, 0, flips === null ? 1 : 0) === 1;
    if (isWhole) return codeMaze(coder, after, this.#choices);
    const blocks = this.#codeFlips(coder, before, flips ?? []);
    if (blocks === null) return null;
    const isStart = this.#bits.code(coder, 1, isSameStart(before, after) ? 0 : 1) === 1;
    const start = isStart
      ? { ...codeCell(coder, after.start), heading: codeHeading(coder, after) }
      : before.start;
    const isGoals = this.#bits.code(coder, 2, isSameGoals(before, after) ? 0 : 1) === 1;
    const goals = isGoals ? this.#codeGoals(coder, after.goals) : before.goals;
    return goals === null ? null : { ...before, blocks, start, goals };
  }

  #codeFlips(coder: BitCoder, before: MazeDocument, flips: readonly number[]): string[] | null {
    const { columns, rows } = sizeOf(before);
    const count = this.#counts.code(coder, flips.length);
    if (count > MAX_FLIPS) return null;
    const blocks = [...before.blocks];
    let last = -1;
    for (let at = 0; at < count; at += 1) {
      last += this.#distances.code(coder, (flips[at] ?? 0) - last - 1) + 1;
      if (last >= columns * rows) return null;
      const column = last % columns;
      const row = (last - column) / columns;
      const line = blocks[row] ?? "";
      const mark = line[column] === BLOCK ? OPEN : BLOCK;
      blocks[row] = line.slice(0, column) + mark + line.slice(column + 1);
    }
    return blocks;
  }

  #codeGoals(coder: BitCoder, goals: readonly Cell[]): Cell[] | null {
    const count = this.#counts.code(coder, goals.length);
    if (count > MAX_GOALS) return null;
    return Array.from({ length: count }, (_, at) => codeCell(coder, goals[at]));
  }
}

/** Codes edits of programs with adaptive models of actions, conditions and numbers. */
export class ProgramEditCoder {
  readonly #choices: Choices;
  /** contexts: did the name change, did the default change, did a line change */
  readonly #bits = new BitModel(3, 4);
  readonly #counts = new NumberModel();
  readonly #actions = new SymbolModel(3);
  readonly #conditions = new ConditionCoder();

  constructor(choices: Choices) {
    this.#choices = choices;
  }

  /**
   * Encodes or decodes an edit.
   * @param after the program to encode; a decoder ignores it, and its caller passes any valid
   *   program
   * @returns the program after the edit, not yet checked by its schema; null if the bits cannot
   *   come from an encoder
   */
  code(coder: BitCoder, before: ProgramDocument, after: ProgramDocument): ProgramDocument | null {
    const isNamed = this.#bits.code(coder, 0, before.name === after.name ? 0 : 1) === 1;
    const isPlain = isNamed && this.#choices.isPlainName(after.name);
    const name = isNamed ? codeName(coder, after.name, MAX_NAME_LENGTH, isPlain) : before.name;
    const isDefault = this.#bits.code(coder, 1, before.default === after.default ? 0 : 1) === 1;
    const byDefault = isDefault ? this.#codeAction(coder, after.default) : before.default;
    const count = this.#counts.code(coder, after.rules.length);
    if (byDefault === undefined || count > MAX_RULES) return null;
    const rules: Rule[] = [];
    for (let at = 0; at < count; at += 1) {
      const rule = this.#codeRule(coder, before.rules[at], after.rules[at]);
      if (rule === null) return null;
      rules.push(rule);
    }
    return { ...before, name, default: byDefault, rules };
  }

  #codeRule(coder: BitCoder, before: Rule | undefined, after: Rule | undefined): Rule | null {
    const isOther = before === undefined || after === undefined || !isSameRule(before, after);
    if (before !== undefined && this.#bits.code(coder, 2, isOther ? 1 : 0) === 0) return before;
    const when = this.#conditions.code(coder, after?.when ?? null);
    const action = this.#codeAction(coder, after?.do ?? "forward");
    return when === undefined || action === undefined ? null : { when, do: action };
  }

  #codeAction(coder: BitCoder, action: PlainAction): PlainAction | undefined {
    return plainActions[this.#actions.code(coder, plainActions.indexOf(action))];
  }
}

/** Indices of the changed cells, row by row; null if the whole maze must be coded. */
function flipsBetween(before: MazeDocument, after: MazeDocument): number[] | null {
  const [size, other] = [sizeOf(before), sizeOf(after)];
  const isSameShape = size.columns === other.columns && size.rows === other.rows;
  if (!isSameShape || before.name !== after.name) return null;
  const cells = cellsOf(after);
  const flips: number[] = [];
  for (const [at, cell] of cellsOf(before).entries()) if (cell !== cells[at]) flips.push(at);
  return flips.length > MAX_FLIPS ? null : flips;
}

function isSameStart({ start: a }: MazeDocument, { start: b }: MazeDocument): boolean {
  return a.column === b.column && a.row === b.row && a.heading === b.heading;
}

function isSameGoals({ goals: a }: MazeDocument, { goals: b }: MazeDocument): boolean {
  return (
    a.length === b.length &&
    a.every(({ column, row }, at) => column === b[at]?.column && row === b[at]?.row)
  );
}

function codeCell(coder: BitCoder, cell: Cell = { column: 0, row: 0 }): Cell {
  const column = codeUniform(coder, MAX_SIDE, cell.column);
  return { column, row: codeUniform(coder, MAX_SIDE, cell.row) };
}

function codeHeading(coder: BitCoder, { start }: MazeDocument): MazeDocument["start"]["heading"] {
  const index = codeUniform(coder, headingNames.length, headingNames.indexOf(start.heading));
  return headingNames[index] ?? "north";
}
