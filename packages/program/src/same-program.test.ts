import fc from "fast-check";
import { describe, expect, it } from "vitest";
import type { ProgramDocument } from "./program-document.ts";
import { isSameBehaviour, isSameProgram } from "./same-program.ts";
import { arbitraryProgram } from "./testing/arbitrary-program.ts";

const program: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "A",
  default: "forward",
  rules: [
    { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
    { when: { sensor: "left", is: ">", than: "right", plus: 5 }, do: "stop" },
    { when: null, do: "stop" },
  ],
};

function withRule(at: number, rule: ProgramDocument["rules"][number]): ProgramDocument {
  return { ...program, rules: program.rules.with(at, rule) };
}

describe("equal programs", () => {
  it("are equal after they were copied", () => {
    fc.assert(
      fc.property(arbitraryProgram, (each) => {
        expect(isSameProgram(each, structuredClone(each))).toBe(true);
      }),
    );
  });

  it("behave the same under another name", () => {
    const renamed = { ...program, name: "B" };
    expect(isSameBehaviour(program, renamed)).toBe(true);
    expect(isSameProgram(program, renamed)).toBe(false);
  });

  it.each<{ name: string; other: ProgramDocument }>([
    { name: "the default", other: { ...program, default: "stop" } },
    { name: "the number of lines", other: { ...program, rules: program.rules.slice(1) } },
    { name: "an action", other: withRule(2, { when: null, do: "forward" }) },
    {
      name: "a number",
      other: withRule(0, { when: { sensor: "front", is: "<", than: 51 }, do: "left 90" }),
    },
    {
      name: "a sensor",
      other: withRule(0, { when: { sensor: "back", is: "<", than: 50 }, do: "left 90" }),
    },
    {
      name: "a comparator",
      other: withRule(0, { when: { sensor: "front", is: ">", than: 50 }, do: "left 90" }),
    },
    {
      name: "the number added to right",
      other: withRule(1, {
        when: { sensor: "left", is: ">", than: "right", plus: 6 },
        do: "stop",
      }),
    },
    { name: "a condition", other: withRule(0, { when: null, do: "left 90" }) },
  ])("differ in $name", ({ other }) => {
    expect(isSameBehaviour(program, other)).toBe(false);
    expect(isSameBehaviour(other, program)).toBe(false);
  });
});
