import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { evaluateCondition } from "./evaluate-condition.ts";
import { arbitraryCondition } from "./testing/arbitrary-program.ts";

const readings = { front: 282, right: 250, back: 418, left: 50 };

describe("evaluateCondition", () => {
  it.each([
    [
      { sensor: "right", is: ">", than: 60 },
      { isTrue: true, left: 250, is: ">", right: 60 },
    ],
    [
      { sensor: "right", is: ">", than: 250 },
      { isTrue: false, left: 250, is: ">", right: 250 },
    ],
    [
      { sensor: "front", is: "<", than: 282 },
      { isTrue: false, left: 282, is: "<", right: 282 },
    ],
    [
      { sensor: "back", is: "<", than: 418.5 },
      { isTrue: true, left: 418, is: "<", right: 418.5 },
    ],
    [
      { sensor: "left", is: "<", than: "right", plus: 1 },
      { isTrue: true, left: 50, is: "<", right: 251 },
    ],
    [
      { sensor: "left", is: ">", than: "right", plus: -200 },
      { isTrue: false, left: 50, is: ">", right: 50 },
    ],
    [
      { sensor: "left", is: ">", than: "right", plus: -201 },
      { isTrue: true, left: 50, is: ">", right: 49 },
    ],
  ] as const)("returns both sides of %j", (condition, expected) => {
    expect(evaluateCondition(condition, readings)).toEqual(expected);
  });

  it("returns null for [Do nothing]", () => {
    expect(evaluateCondition(null, readings)).toBeNull();
  });

  it("is never true for both > and <", () => {
    fc.assert(
      fc.property(arbitraryCondition, (condition) => {
        const other = { ...condition, is: condition.is === ">" ? "<" : ">" } as typeof condition;
        const both = [evaluateCondition(condition, readings), evaluateCondition(other, readings)];
        expect(both.filter((each) => each?.isTrue).length).toBeLessThan(2);
        expect(both[0]?.right).toBe(both[1]?.right);
      }),
    );
  });
});
