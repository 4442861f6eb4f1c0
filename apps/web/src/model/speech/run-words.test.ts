import type { ProgramDocument } from "@corridor/program";
import { snapshotOf } from "@corridor/protocol/testing";
import { beforeAll, describe, expect, it } from "vitest";
import { createRunStore, type RunState } from "../run/run-store.ts";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import { decisionText, describeText } from "./run-words.ts";

const i18n = createI18n(en);
const words = { t: i18n.t, language: "en" };
beforeAll(() => i18n.loadNamespaces("runDetails"));

const program: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "Right at walls",
  rules: [{ when: { sensor: "front", is: "<", than: 50 }, do: "right 90" }],
  default: "left 90",
};

function stateOf(
  line: 0 | "default" | null,
  front: number,
  changes: Partial<RunState> = {},
): RunState {
  const sensors = { front, right: 50, back: 100, left: 50 };
  const snapshot = snapshotOf({ tick: 60, driver: "program", line, sensors });
  return { ...createRunStore().getInitialState(), snapshot, ...changes };
}

const turn = (left: number): RunState["progress"] => ({
  direction: 1,
  action: "right 90",
  part: 0,
  parts: 1,
  kind: "turn",
  left,
  of: 90,
});

describe("the announcement of a line", () => {
  it("says the reading on which the line decided", () => {
    const text = decisionText(words, program, 0, stateOf(0, 48.3, { progress: turn(90) }), true);
    expect(text).toBe("Line 1: right 90. Front is 48.3 cm.");
  });

  it.each([
    { line: 0, text: "Line 1: right 90." },
    { line: "default", text: "Otherwise: left 90." },
  ] as const)("says no reading from the middle of a turn: $text", ({ line, text }) => {
    const state = stateOf(line, 65.6, { progress: turn(43.2) });
    expect(decisionText(words, program, line, state, true)).toBe(text);
  });

  it("says no reading where the task hides what is true", () => {
    const state = stateOf(0, 48.3, { progress: turn(90) });
    expect(decisionText(words, program, 0, state, false)).toBe("Line 1: right 90.");
  });

  it("says no reading of the place where the line ended the run", () => {
    const state = stateOf("default", 25, { hasEnded: true });
    expect(decisionText(words, program, "default", state, true)).toBe("Otherwise: left 90.");
  });
});

describe("the description of the robot", () => {
  const last = (state: RunState, hasTruth = true): string =>
    describeText(words, program, state, hasTruth).split("left 50 cm. ")[1] ?? "";

  it("gives the reason where the line decides", () => {
    expect(last(stateOf(0, 48, { progress: turn(90) }))).toBe(
      "Line 1, running: if front is less than 50, right 90. Front is 48, true.",
    );
    expect(last(stateOf(0, 48, { progress: turn(90) }), false)).toBe(
      "Line 1, running: if front is less than 50, right 90.",
    );
    expect(last(stateOf("default", 63))).toBe("No line is true, so “otherwise” decides: left 90.");
    expect(last(stateOf(null, 63))).toBe("No line has decided yet.");
  });

  it.each([
    { line: 0, text: "Line 1: right 90, 44 degrees to go." },
    { line: "default", text: "Otherwise: left 90, 44 degrees to go." },
    { line: null, text: "44 degrees to go." },
  ] as const)("says in the middle of a turn how far it is: $text", ({ line, text }) => {
    expect(last(stateOf(line, 40, { progress: turn(43.2) }))).toBe(text);
  });

  it("does not call the lines false where the run has ended", () => {
    expect(last(stateOf("default", 25, { hasEnded: true }))).toBe("Otherwise: left 90.");
  });
});
