import type { SensorReadings } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { CompiledProgram } from "./compiled-program.ts";
import { evaluateCondition } from "./evaluate-condition.ts";
import type { ProgramDocument } from "./program-document.ts";
import { arbitraryProgram } from "./testing/arbitrary-program.ts";

/** Readings that are often exactly at the limit of a line, where a comparison is easily wrong. */
function readingsNear({ rules }: ProgramDocument): fc.Arbitrary<SensorReadings> {
  const numbers = rules.flatMap(({ when }) =>
    when === null ? [] : [when.than === "right" ? when.plus : when.than],
  );
  const sums = numbers.flatMap((one) => numbers.map((other) => one + other));
  const distance = fc.oneof(
    fc.constantFrom(0, ...numbers, ...sums),
    fc.double({ min: 0, max: 10_000, noNaN: true }),
  );
  return fc.record({ front: distance, right: distance, back: distance, left: distance });
}

/** The first line that is true by the comparisons that the page displays; -1 for the default. */
function firstTrueLine({ rules }: ProgramDocument, readings: SensorReadings): number {
  return rules.findIndex(({ when }) => evaluateCondition(when, readings)?.isTrue === true);
}

const situation = arbitraryProgram.chain((program) =>
  fc.record({ program: fc.constant(program), readings: readingsNear(program) }),
);

function decide(program: ProgramDocument, { front, right, back, left }: SensorReadings): number {
  return new CompiledProgram(program).decide(Float64Array.of(front, right, back, left));
}

describe("the decision of a compiled program", () => {
  it("is the first line that the page displays as true", () => {
    fc.assert(
      fc.property(situation, ({ program, readings }) => {
        expect(decide(program, readings)).toBe(firstTrueLine(program, readings));
      }),
      { numRuns: 500 },
    );
  });

  it("executes the action of that line, or the default", () => {
    fc.assert(
      fc.property(situation, ({ program, readings }) => {
        const rule = decide(program, readings);
        const action = program.rules[rule]?.do ?? program.default;
        expect(new CompiledProgram(program).commandOf(rule)).toEqual({ action });
      }),
    );
  });

  it("is the default where every line does nothing", () => {
    const program: ProgramDocument = {
      format: "corridor/program",
      version: 1,
      name: "",
      default: "forward",
      rules: [{ when: null, do: "stop" }],
    };
    expect(decide(program, { front: 0, right: 0, back: 0, left: 0 })).toBe(-1);
  });
});
