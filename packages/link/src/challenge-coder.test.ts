import {
  conditionNames,
  editKinds,
  MAX_CHECK_SECONDS,
  type ChallengeDocument,
  type Goal,
} from "@corridor/challenge";
import { generateTree } from "@corridor/maze";
import { arbitraryMaze } from "@corridor/maze/testing";
import { programPresets } from "@corridor/program";
import { arbitraryProgram } from "@corridor/program/testing";
import { plainActions, sensorNames } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { decodeLink, encodeLink, type LinkContent } from "./link.ts";

const text = (max: number) => fc.string({ unit: "binary", maxLength: max });
const some = <Name>(names: readonly Name[], minLength = 0) =>
  fc.uniqueArray(fc.constantFrom(...names), { minLength });
const distance = fc.double({ min: 1, max: 50_000, noNaN: true });

const anyGoal: fc.Arbitrary<Goal> = fc.oneof(
  fc.constantFrom<Goal>({ kind: "reach" }, { kind: "visit" }),
  fc.record({ kind: fc.constant("drive" as const), distance }),
  fc.record({ kind: fc.constant("last" as const), seconds: fc.integer({ min: 1, max: 20 }) }),
  fc.tuple(fc.constantFrom(...sensorNames), distance, distance).map(([sensor, a, b]): Goal => ({
    kind: "stop",
    sensor,
    from: Math.min(a, b),
    to: Math.max(a, b),
  })),
);

const anyChallenge: fc.Arbitrary<ChallengeDocument> = fc.record({
  format: fc.constant("corridor/challenge" as const),
  version: fc.constant(1 as const),
  name: text(60),
  words: fc.record({
    task: text(120),
    short: text(60),
    hints: fc.array(text(80), { maxLength: 4 }),
  }),
  mazes: fc.array(
    arbitraryMaze.map((maze) => ({
      ...maze,
      goals: [{ column: maze.start.column, row: maze.start.row }],
    })),
    { minLength: 1, maxLength: 3 },
  ),
  program: fc.option(arbitraryProgram),
  goal: anyGoal,
  allowed: fc.record({
    drivers: some(["me", "program", "remote"] as const, 1),
    lines: fc.constant(200),
    conditions: fc.option(some(conditionNames)),
    actions: fc.option(some(plainActions)),
    edits: some(editKinds),
    maze: fc.boolean(),
  }),
  checks: fc.record({
    bumps: fc.option(fc.integer({ min: 0, max: 1_000 })),
    seconds: fc.integer({ min: 20, max: MAX_CHECK_SECONDS }),
  }),
  par: fc.option(
    fc.record({
      lines: fc.integer({ min: 0, max: 200 }),
      seconds: fc.double({ min: 0, max: 600, noNaN: true }),
    }),
  ),
});

describe("the link of a challenge", () => {
  it("decodes to equal documents, with or without a program", () => {
    fc.assert(
      fc.property(anyChallenge, fc.option(arbitraryProgram), (challenge, program) => {
        const content: LinkContent = program === null ? { challenge } : { challenge, program };
        const link = encodeLink(content);
        const isTooBig = !link.ok && link.code === "too-big";
        expect(link.ok || isTooBig).toBe(true);
        expect(link.ok ? decodeLink(link.text) : isTooBig).toEqual(
          link.ok ? { ok: true, value: content } : true,
        );
      }),
      { numRuns: 200 },
    );
  });

  it("has at most 400 characters for a maze of 21 x 21 with a task and two hints", () => {
    const challenge: ChallengeDocument = {
      format: "corridor/challenge",
      version: 1,
      name: "Find the way out",
      words: {
        task: "Write a program that reaches the goal. Use 3 lines or fewer, and do not bump.",
        short: "Reach the goal in 3 lines or fewer",
        hints: ["Keep a hand on the right wall.", "A side opening needs a delayed turn."],
      },
      mazes: [
        {
          ...generateTree({ columns: 21, rows: 21, seed: 5, name: "Find the way out" }),
          goals: [{ column: 1, row: 1 }],
        },
      ],
      program: programPresets[0]?.program ?? null,
      goal: { kind: "reach" },
      allowed: {
        drivers: ["program"],
        lines: 3,
        conditions: null,
        actions: null,
        edits: ["condition", "number", "action", "otherwise", "order", "lines"],
        maze: false,
      },
      checks: { bumps: 0, seconds: 300 },
      par: { lines: 2, seconds: 90 },
    };
    const link = encodeLink({ challenge });
    if (!link.ok) throw new Error(link.code);
    expect(decodeLink(link.text)).toEqual({ ok: true, value: { challenge } });
    expect(link.text.length).toBeLessThanOrEqual(400);
  });
});
