import { lessonOf, MAX_CHECK_SECONDS, type ChallengeDocument } from "@corridor/challenge";
import { generateTree } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import { arbitraryProgram } from "@corridor/program/testing";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { decodeLink, encodeLink } from "./link.ts";
import type { LinkContent } from "./link-body.ts";
import { arbitraryTask } from "./testing/arbitrary-task.ts";

const anyChallenge = arbitraryTask(MAX_CHECK_SECONDS).map((task): ChallengeDocument => ({
  format: "corridor/challenge",
  version: 1,
  ...task,
}));

describe("the link of a challenge", () => {
  it("decodes to equal documents, with or without a program", () => {
    fc.assert(
      fc.property(anyChallenge, fc.option(arbitraryProgram), (challenge, program) => {
        const lesson = lessonOf(challenge);
        const content: LinkContent = program === null ? { lesson } : { lesson, program };
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
    const lesson = lessonOf(challenge);
    const link = encodeLink({ lesson });
    if (!link.ok) throw new Error(link.code);
    expect(decodeLink(link.text)).toEqual({ ok: true, value: { lesson } });
    expect(link.text.length).toBeLessThanOrEqual(400);
  });
});
