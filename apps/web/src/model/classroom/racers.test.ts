import { programPresets } from "@corridor/program";
import { MAX_RACERS } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { racersOf } from "./racers.ts";
import type { Verification } from "./verifier.ts";

const [preset] = programPresets;
if (preset === undefined) throw new Error("the presets are gone");
const { program } = preset;

const claimOf = (code: string) => ({ code, activeAt: 0, lines: 2, attempts: 1 });
const passes = (code: string): Verification => ({
  kind: "passes",
  claim: claimOf(code),
  attempt: program,
});

function verifications(...all: Verification[]) {
  return new Map(all.map((each, at) => [at + 1, new Map([[2, each]])]));
}

describe("the racers of a task", () => {
  it("are the verified programs, each with the number of its students", () => {
    const found = racersOf(2, verifications(passes("b"), passes("a"), passes("b"), passes("c")));
    expect(found).toEqual([
      { code: "b", count: 2 },
      { code: "a", count: 1 },
      { code: "c", count: 1 },
    ]);
  });

  it.each<[string, Verification]>([
    ["a claim that is not verified yet", { kind: "checking" }],
    ["a claim that fails", { kind: "fails", claim: claimOf("a"), attempt: program }],
    ["a manual drive", { kind: "passes", claim: claimOf("a"), attempt: [] }],
  ])("do not include %s", (_, verification) => {
    expect(racersOf(2, verifications(verification))).toEqual([]);
  });

  it("do not include solutions of other tasks", () => {
    expect(racersOf(1, verifications(passes("a")))).toEqual([]);
  });

  it("are limited in number and in characters", () => {
    const many = Array.from({ length: 60 }, (_, at) => passes(`1Zz${at}`));
    expect(racersOf(2, verifications(...many))).toHaveLength(MAX_RACERS);
    const long = Array.from({ length: 30 }, (_, at) => passes(`${at}`.padStart(4_000, "x")));
    const codes = racersOf(2, verifications(...long)).map(({ code }) => code);
    expect(codes.join("").length).toBeLessThanOrEqual(32_768);
    expect(codes).toHaveLength(8);
  });
});
