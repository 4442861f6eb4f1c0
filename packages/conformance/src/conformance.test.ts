/** There is one check for each promise, and the report contains the results. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { linesOf, passes, verdict } from "./report.ts";
import { groups, runChecks, type Outcome, type Result } from "./run-checks.ts";

const PROMISES = join(import.meta.dirname, "../../../apps/relay/src/site/docs/pages/promises.md");

/** The ids of the table below "What every host promises". */
function promises(): string[] {
  const [, section = ""] = readFileSync(PROMISES, "utf8").split("\n## What every host promises\n");
  const [table = ""] = section.split(/\n#{2,3} /);
  return [...table.matchAll(/^\| `([a-z-]+)`/gm)].map(([, id = ""]) => id);
}

function resultsOf(...outcomes: Outcome[]): Result[] {
  return outcomes.map((outcome) => ({ group: "Stop", promise: "stop", check: "a stop", outcome }));
}

const passed: Outcome = { kind: "passed" };
const failed: Outcome = { kind: "failed", expected: "completed", found: "started" };
const notOffered: Outcome = { kind: "not offered", feature: "pose", why: "It has no camera." };
const notTestable: Outcome = {
  kind: "not testable",
  why: "the robot is not at its place",
  isNever: false,
};
const neverTestable: Outcome = { kind: "not testable", why: "it takes 10 minutes", isNever: true };

describe("the conformance kit", () => {
  it("has one check for each promise of the documentation, and no other", () => {
    const checks = groups.flatMap((group) => group.checks.map(({ promise }) => promise));
    expect(promises().length).toBeGreaterThan(50);
    expect(checks.toSorted()).toEqual(promises().toSorted());
  });

  it("rejects an invalid address", async () => {
    await expect(runChecks("http://localhost/r/abc")).rejects.toThrow("not a robot's address");
  });

  it("separates what fails, what is not offered and what cannot be tested", () => {
    const report = resultsOf(passed, failed, notOffered, notTestable).map(linesOf);
    expect(report).toEqual([
      ["  ok                 stop: a stop"],
      [
        "  FAILED             stop: a stop",
        "                     expected: completed",
        "                     found:    started",
      ],
      ["  not offered        stop: a stop", "                     pose: It has no camera."],
      ["  not testable here  stop: a stop", "                     the robot is not at its place"],
    ]);
  });

  it.each([
    { outcomes: [passed, passed], word: "PASSED, 2 passed, 0 failed, 0 not offered, 0 not" },
    { outcomes: [passed, notOffered], word: "PASSED, 1 passed, 0 failed, 1 not offered (pose), 0" },
    {
      outcomes: [passed, neverTestable],
      word: "PASSED, 1 passed, 0 failed, 0 not offered, 1 not testable here",
    },
    { outcomes: [passed, notTestable], word: "INCOMPLETE, 1 passed, 0 failed, 0 not offered, 1" },
    { outcomes: [failed, notTestable], word: "FAILED, 0 passed, 1 failed, 0 not offered, 1 not" },
  ])("ends with a line to publish: $word", ({ outcomes, word }) => {
    const results = resultsOf(...outcomes);
    expect(verdict(results, "2026-11-25")).toContain(
      `Corridor conformance, protocol 1, 2026-11-25: ${word}`,
    );
    expect(passes(results)).toBe(word.startsWith("PASSED"));
  });
});
