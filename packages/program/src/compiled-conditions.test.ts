import type { UntilCondition } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { CompiledConditions } from "./compiled-conditions.ts";

/** front, right, back, left */
const READINGS = Float64Array.of(60, 50, 40, 51);

function isTrue(condition: UntilCondition, isInGoal = false): boolean {
  return new CompiledConditions([condition]).firstTrue(READINGS, isInGoal) === 0;
}

describe("compiled conditions", () => {
  it.each([
    { is: "<=", than: 60, wanted: true },
    { is: "<", than: 60, wanted: false },
    { is: ">=", than: 60, wanted: true },
    { is: ">", than: 60, wanted: false },
    { is: "<", than: 60.000001, wanted: true },
    { is: ">", than: 59.999999, wanted: true },
  ] as const)("front 60 is $is $than: $wanted", ({ is, than, wanted }) => {
    expect(isTrue({ sensor: "front", is, than })).toBe(wanted);
  });

  it.each([
    { is: ">", plus: 0, wanted: true },
    { is: ">", plus: 1, wanted: false },
    { is: ">=", plus: 1, wanted: true },
    { is: "<=", plus: 1, wanted: true },
    { is: "<", plus: 2, wanted: true },
    { is: "<", plus: -2, wanted: false },
  ] as const)("left 51 is $is right 50 + $plus: $wanted", ({ is, plus, wanted }) => {
    expect(isTrue({ sensor: "left", is, than: "right", plus })).toBe(wanted);
  });

  it("are true in a goal only if they ask for one", () => {
    expect(isTrue({ goal: true }, true)).toBe(true);
    expect(isTrue({ goal: true })).toBe(false);
    expect(isTrue({ sensor: "back", is: ">", than: 40 }, true)).toBe(false);
  });

  it("return the first that is true", () => {
    const conditions = new CompiledConditions([
      { sensor: "back", is: ">", than: 40 },
      { goal: true },
      { sensor: "right", is: ">=", than: 50 },
      { sensor: "front", is: "<=", than: 60 },
    ]);
    expect(conditions.firstTrue(READINGS)).toBe(2);
    expect(conditions.firstTrue(READINGS, true)).toBe(1);
    expect(new CompiledConditions([]).firstTrue(READINGS, true)).toBe(-1);
  });
});
