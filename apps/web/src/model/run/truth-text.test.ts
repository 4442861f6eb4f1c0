import { evaluateCondition, type EvaluatedCondition } from "@corridor/program";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { truthText } from "./truth-text.ts";

const at = (front: number) => ({ front, right: 50, back: 50, left: 250 });

function shown(truth: EvaluatedCondition): string {
  const { left, right } = truthText(truth);
  return `${left} ${right}`;
}

function text(front: number, is: ">" | "<", than: number): string {
  const truth = evaluateCondition({ sensor: "front", is, than }, at(front));
  if (truth === null) throw new Error("expected a condition");
  return shown(truth);
}

describe("truthText", () => {
  it.each([
    [250, ">", 60, "250 > 60"],
    [250.46, ">", 60, "250.5 > 60"],
    [50.04, ">", 50, "50.04 > 50"],
    [49.96, "<", 50, "49.96 < 50"],
    [49.96, ">", 50, "50 > 50"],
    [50, ">", 50, "50 > 50"],
    [50.000001, ">", 50, "50.01 > 50"],
    [49.999_999_999_999, "<", 50, "49.99 < 50"],
    [0.3, "<", 12.25, "0.3 < 12.3"],
  ] as const)("shows %d %s %d as %s", (front, is, than, expected) => {
    expect(text(front, is, than)).toBe(expected);
  });

  it("shows left against right with the line's number already added", () => {
    const truth = evaluateCondition({ sensor: "left", is: ">", than: "right", plus: 1 }, at(0));
    expect(truth && shown(truth)).toBe("250 > 51");
  });

  it("never shows numbers that contradict the mark before them", () => {
    const reading = fc.double({ min: 0, max: 25_600, noNaN: true });
    const close = fc.double({ min: -1e-6, max: 1e-6, noNaN: true });
    fc.assert(
      fc.property(reading, close, fc.constantFrom(">", "<"), (number, offset, is) => {
        const front = Math.max(0, number + offset);
        const [left = "", , right = ""] = text(front, is, number).split(" ");
        const isTrue = is === ">" ? front > number : front < number;
        expect(is === ">" ? Number(left) > Number(right) : Number(left) < Number(right)).toBe(
          isTrue,
        );
      }),
    );
  });
});
