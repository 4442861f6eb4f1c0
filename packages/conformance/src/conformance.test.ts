/** The report of the kit. */
import { robotAddresses } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { readAddress } from "./host.ts";
import { linesOf, passes, verdict } from "./report.ts";
import { runChecks, type Outcome, type Result } from "./run-checks.ts";

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
  it("rejects an invalid address", async () => {
    await expect(runChecks("http://localhost/r/abc")).rejects.toThrow("not a robot's address");
  });

  it("accepts the addresses that every client accepts, and no others", () => {
    for (const { text, ...parts } of robotAddresses.good) expect(readAddress(text)).toEqual(parts);
    for (const text of robotAddresses.bad) expect(readAddress(text)).toBeNull();
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
