import { programPresets } from "@corridor/program";
import { MAX_RACERS } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { raceField, raceMazes } from "./racers.ts";
import { firstMaze } from "../../simulator/protocol/first-project.ts";
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
    const { racers: found, missing } = raceField(
      2,
      verifications(passes("b"), passes("a"), passes("b"), passes("c")),
    );
    expect(found).toEqual([
      { code: "b", count: 2 },
      { code: "a", count: 1 },
      { code: "c", count: 1 },
    ]);
    expect(missing).toEqual([]);
  });

  it.each<[string, Verification]>([
    ["a claim that is not verified yet", { kind: "checking" }],
    ["a claim that fails", { kind: "fails" }],
    ["a drive", { kind: "passes", claim: claimOf("a"), attempt: [] }],
  ])("do not include %s", (_, verification) => {
    expect(raceField(2, verifications(verification)).racers).toEqual([]);
  });

  it("do not include solutions of other tasks", () => {
    expect(raceField(1, verifications(passes("a"))).racers).toEqual([]);
  });

  it("are limited in number and in characters, and the others are missing", () => {
    const many = Array.from({ length: 42 }, (_, at) => passes(`1Zz${10 + at}`));
    const field = raceField(2, verifications(...many, passes("1Zz51")));
    expect(field.racers).toHaveLength(MAX_RACERS);
    expect(field.racers[0]).toEqual({ code: "1Zz51", count: 2 });
    expect(field.missing).toEqual([40, 41]);
    const long = Array.from({ length: 30 }, (_, at) => passes(`${at}`.padStart(4_000, "x")));
    const { racers, missing } = raceField(2, verifications(...long));
    const codes = racers.map(({ code }) => code);
    expect(codes.join("").length).toBeLessThanOrEqual(32_768);
    expect(codes).toHaveLength(8);
    expect(missing).toHaveLength(22);
  });
});

it("a task races in its given mazes, or in the first ten unseen ones", () => {
  const maze = firstMaze;
  const unseen = { kind: "tree", columns: 11, rows: 11, seed: 7, count: 50, pass: 45 } as const;
  expect(raceMazes({ mazes: [maze, maze], unseen: null })).toEqual(["g1", "g2"]);
  expect(raceMazes({ mazes: [maze], unseen: { ...unseen, count: 2, pass: 1 } })).toEqual([
    "g1",
    "u1",
    "u2",
  ]);
  expect(raceMazes({ mazes: [maze], unseen })).toHaveLength(11);
});
