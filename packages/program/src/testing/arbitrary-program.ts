/** Random valid programs for property tests: any name, condition, action and number. */
import { plainActions } from "@corridor/protocol";
import fc from "fast-check";
import { conditionOf, numberRange } from "../condition-parts.ts";
import type { Condition, ProgramDocument } from "../program-document.ts";
import { conditionKinds, MAX_NAME_LENGTH, MAX_RULES, type ConditionKind } from "../vocabulary.ts";

function numberFor(kind: ConditionKind): fc.Arbitrary<number> {
  const { min, max } = numberRange(kind);
  return fc.oneof(
    { weight: 4, arbitrary: fc.integer({ min, max }) },
    { weight: 1, arbitrary: fc.double({ min, max, noNaN: true }) },
  );
}

/** Generates valid conditions. */
export const arbitraryCondition: fc.Arbitrary<Condition> = fc
  .constantFrom(...conditionKinds)
  .chain((kind) => numberFor(kind).map((number) => conditionOf(kind, number)));

/** Generates valid programs. */
export const arbitraryProgram: fc.Arbitrary<ProgramDocument> = fc.record({
  format: fc.constant("corridor/program" as const),
  version: fc.constant(1 as const),
  name: fc.string({ unit: "binary", maxLength: MAX_NAME_LENGTH / 2 }),
  default: fc.constantFrom(...plainActions),
  rules: fc.array(
    fc.record({
      when: fc.option(arbitraryCondition, { freq: 6 }),
      do: fc.constantFrom(...plainActions),
    }),
    { maxLength: MAX_RULES, size: "medium" },
  ),
});
