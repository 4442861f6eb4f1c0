import { describeProblem, plainActions } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { parseProgram, type ProgramDocument, type Rule } from "./program-document.ts";
import {
  addRule,
  moveRule,
  removeRule,
  rename,
  setAction,
  setCondition,
  setDefault,
  setNumber,
  type ProgramEdit,
} from "./program-edit.ts";
import { arbitraryProgram } from "./testing/arbitrary-program.ts";
import { conditionKinds, type ConditionKind } from "./vocabulary.ts";

const a: Rule = { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" };
const b: Rule = { when: { sensor: "left", is: "<", than: "right", plus: -7 }, do: "left 90" };
const c: Rule = { when: null, do: "stop" };
const program: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "Three",
  default: "forward",
  rules: [a, b, c],
};
const frontLess: ConditionKind = { sensor: "front", is: "<", than: "number" };
const leftMore: ConditionKind = { sensor: "left", is: ">", than: "right" };

function edited(edit: ProgramEdit): ProgramDocument {
  if (!edit.ok) throw new Error(`refused as ${edit.code}`);
  return edit.program;
}

describe("lines", () => {
  it("a new line is [Do nothing] with the action forward", () => {
    expect(edited(addRule(program)).rules).toEqual([a, b, c, { when: null, do: "forward" }]);
  });

  it("removing a line keeps the objects of the others", () => {
    const { rules } = edited(removeRule(program, 1));
    expect(rules).toEqual([a, c]);
    expect(rules[0]).toBe(a);
  });

  it.each([
    [0, 1, [b, a, c]],
    [2, -2, [c, a, b]],
    [0, 99, [b, c, a]],
    [1, -99, [b, a, c]],
  ])("line %i moves by %i, at most to the first or last position", (index, by, rules) => {
    expect(edited(moveRule(program, index, by)).rules).toEqual(rules);
  });
});

describe("conditions", () => {
  it.each([
    ["retains the number between sensors", 0, frontLess, { sensor: "front", is: "<", than: 60 }],
    [
      "retains the number for left compared with right",
      0,
      leftMore,
      { sensor: "left", is: ">", than: "right", plus: 60 },
    ],
    ["raises a negative number to 0", 1, frontLess, { sensor: "front", is: "<", than: 0 }],
    ["sets 50 on an empty line", 2, frontLess, { sensor: "front", is: "<", than: 50 }],
    ["removes the condition for [Do nothing]", 0, null, null],
  ] as const)("setCondition %s", (_, index, kind, when) => {
    expect(edited(setCondition(program, index, kind)).rules[index]?.when).toEqual(when);
  });

  it("accept fractions and, for left compared with right, negative numbers", () => {
    expect(edited(setNumber(program, 0, 0.25)).rules[0]?.when).toEqual({ ...a.when, than: 0.25 });
    expect(edited(setNumber(program, 1, -99.5)).rules[1]?.when).toEqual({ ...b.when, plus: -99.5 });
  });
});

describe("actions and name", () => {
  it("change", () => {
    expect(edited(setAction(program, 2, "turn 180")).rules[2]).toEqual({ ...c, do: "turn 180" });
    expect(setDefault(program, "stop").default).toBe("stop");
    expect(edited(rename(program, "")).name).toBe("");
  });
});

describe("an edit that changes nothing", () => {
  it.each([
    ["a move past the top", edited(moveRule(program, 0, -1))],
    ["a move past the end", edited(moveRule(program, 2, 1))],
    [
      "the same condition",
      edited(setCondition(program, 0, { ...frontLess, sensor: "right", is: ">" })),
    ],
    ["[Do nothing] for [Do nothing]", edited(setCondition(program, 2, null))],
    ["the same number", edited(setNumber(program, 1, -7))],
    ["the same action", edited(setAction(program, 0, "delayed right 90"))],
    ["the same default", setDefault(program, "forward")],
    ["the same name", edited(rename(program, "Three"))],
  ])("returns the same object: %s", (_, after) => {
    expect(after).toBe(program);
  });
});

describe("a refused edit", () => {
  const full = { ...program, rules: Array.from({ length: 200 }, () => c) };
  it.each<[string, ProgramEdit, string]>([
    ["line 201", addRule(full), "too-many-rules"],
    ["removing line 4 of 3", removeRule(program, 3), "no-such-rule"],
    ["moving a missing line", moveRule(program, -1, 1), "no-such-rule"],
    ["a condition for a missing line", setCondition(program, 3, null), "no-such-rule"],
    ["an action for a missing line", setAction(program, 0.5, "stop"), "no-such-rule"],
    ["a number for a missing line", setNumber(program, 3, 1), "no-such-rule"],
    ["a number for [Do nothing]", setNumber(program, 2, 1), "no-condition"],
    ["a negative distance", setNumber(program, 0, -1), "bad-number"],
    ["a distance above 100000", setNumber(program, 0, 100_001), "bad-number"],
    ["an addition below -100000", setNumber(program, 1, -100_001), "bad-number"],
    ["NaN", setNumber(program, 0, Number.NaN), "bad-number"],
    ["Infinity", setNumber(program, 1, Number.POSITIVE_INFINITY), "bad-number"],
    ["a name of 101 characters", rename(program, "x".repeat(101)), "name-too-long"],
  ])("returns a code: %s", (_, edit, code) => {
    expect(edit).toEqual({ ok: false, code });
  });
});

describe("any sequence of edits", () => {
  const index = fc.integer({ min: -1, max: 12 });
  const number = fc.oneof(fc.integer({ min: -100, max: 300 }), fc.double());
  const action = fc.constantFrom(...plainActions);
  type Edit = (from: ProgramDocument) => ProgramEdit;
  const edits: fc.Arbitrary<Edit[]> = fc.array(
    fc.oneof(
      fc.constant<Edit>((from) => addRule(from)),
      index.map(
        (at): Edit =>
          (from) =>
            removeRule(from, at),
      ),
      fc.tuple(index, fc.integer({ min: -5, max: 5 })).map(
        ([at, by]): Edit =>
          (from) =>
            moveRule(from, at, by),
      ),
      fc.tuple(index, fc.constantFrom(null, ...conditionKinds)).map(
        ([at, kind]): Edit =>
          (from) =>
            setCondition(from, at, kind),
      ),
      fc.tuple(index, number).map(
        ([at, value]): Edit =>
          (from) =>
            setNumber(from, at, value),
      ),
      fc.tuple(index, action).map(
        ([at, chosen]): Edit =>
          (from) =>
            setAction(from, at, chosen),
      ),
      action.map((chosen): Edit => (from) => ({ ok: true, program: setDefault(from, chosen) })),
      fc.string({ maxLength: 120 }).map(
        (name): Edit =>
          (from) =>
            rename(from, name),
      ),
    ),
    { maxLength: 30 },
  );

  it("results in a valid document and never changes an earlier one", () => {
    fc.assert(
      fc.property(arbitraryProgram, edits, (first, sequence) => {
        const history: { document: ProgramDocument; text: string }[] = [];
        let current = first;
        for (const edit of sequence) {
          history.push({ document: current, text: JSON.stringify(current) });
          const result = edit(current);
          if (!result.ok) continue;
          current = result.program;
          const read = parseProgram(current);
          expect(read.ok ? [] : read.problems.map(describeProblem)).toEqual([]);
        }
        for (const { document, text } of history) expect(JSON.stringify(document)).toBe(text);
      }),
    );
  });
});
