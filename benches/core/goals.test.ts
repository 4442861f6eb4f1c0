import { describe, expect, it } from "vitest";
import { formatGoal, isMet, type Goal } from "./goals.ts";

function goal(measured: number, bound: Goal["bound"]): Goal {
  return { label: "a tick", measured, bound, unit: "times" };
}

describe("a goal", () => {
  it.each([
    { name: "at its upper bound", it: goal(20, { atMost: 20 }), met: true },
    { name: "above its upper bound", it: goal(20.1, { atMost: 20 }), met: false },
    { name: "at its lower bound", it: goal(90, { atLeast: 90 }), met: true },
    { name: "below its lower bound", it: goal(89.9, { atLeast: 90 }), met: false },
    {
      name: "that could not be measured, with an upper bound",
      it: goal(NaN, { atMost: 1 }),
      met: false,
    },
    {
      name: "that could not be measured, with a lower bound",
      it: goal(NaN, { atLeast: 1 }),
      met: false,
    },
  ])("$name is met: $met", ({ it: each, met }) => {
    expect(isMet(each)).toBe(met);
    expect(formatGoal(each).startsWith(met ? "PASS" : "FAIL")).toBe(true);
  });

  it("prints the measured number and the bound", () => {
    expect(formatGoal(goal(6091.4, { atLeast: 2500 }))).toBe(
      "PASS  a tick: 6,090 times (at least 2500)",
    );
  });
});
