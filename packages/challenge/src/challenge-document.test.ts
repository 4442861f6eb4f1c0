import { describe, expect, it } from "vitest";
import { parseChallenge, readChallenge } from "./challenge-document.ts";
import { sampleChallenge as sample } from "./testing/sample-challenge.ts";

const { allowed, checks, goal, mazes, words } = sample;
const [maze] = mazes;

describe("reading a challenge", () => {
  it("returns an equal document", () => {
    expect(parseChallenge(sample)).toEqual({ ok: true, value: sample });
    expect(readChallenge(JSON.stringify(sample))).toEqual({ ok: true, value: sample });
  });

  it.each([
    ["another format", { ...sample, format: "corridor/maze" }, "format", '"corridor/challenge"'],
    ["a newer version", { ...sample, version: 2 }, "version", "version 1"],
    ["no mazes", { ...sample, mazes: [] }, "mazes", "at least one maze"],
    ["eleven mazes", { ...sample, mazes: Array(11).fill(maze) }, "mazes", "at most 10 mazes"],
    [
      "a broken maze",
      { ...sample, mazes: [{ ...maze, start: { column: 0, row: 0, heading: "east" } }] },
      "mazes[0].start",
      "an open cell, not a block",
    ],
    [
      "no goal to reach",
      { ...sample, mazes: [{ ...maze, goals: [] }] },
      "mazes[0].goals",
      "at least one goal",
    ],
    ["an unknown goal", { ...sample, goal: { kind: "fly" } }, "goal.kind", "one of reach"],
    [
      "a stop goal with an empty range",
      { ...sample, goal: { kind: "stop", sensor: "front", from: 90, to: 80 } },
      "goal.from",
      "at most the value of `to`",
    ],
    [
      "a goal after the time limit",
      { ...sample, goal: { kind: "last", seconds: 40 } },
      "goal.seconds",
      "at most the seconds of the checks",
    ],
    [
      "no driver",
      { ...sample, allowed: { ...allowed, drivers: [] } },
      "allowed.drivers",
      "at least one",
    ],
    [
      "a duplicate driver",
      { ...sample, allowed: { ...allowed, drivers: ["me", "me"] } },
      "allowed.drivers",
      "no duplicates",
    ],
    [
      "an unknown action",
      { ...sample, allowed: { ...allowed, actions: ["fly"] } },
      "allowed.actions[0]",
      "one of forward",
    ],
    [
      "fewer lines than the starting program",
      { ...sample, allowed: { ...allowed, lines: 1 } },
      "allowed.lines",
      "at least the 2 lines",
    ],
    [
      "no time",
      { ...sample, checks: { ...checks, seconds: 0 } },
      "checks.seconds",
      "a whole number from 1",
    ],
    [
      "seven hints",
      { ...sample, words: { ...words, hints: Array(7).fill("?") } },
      "words.hints",
      "at most 6 hints",
    ],
    [
      "an unknown field",
      { ...sample, goal: { ...goal, by: "noon" } },
      "goal.by",
      "no field of this name",
    ],
    ["a missing field", { ...sample, par: undefined }, "par", "a par"],
  ])("rejects %s with path, found and expected", (_, input, path, expected) => {
    const read = parseChallenge(input);
    expect(read.ok).toBe(false);
    const problem = read.ok ? undefined : read.problems.find((each) => each.path === path);
    expect(problem?.expected).toContain(expected);
  });

  it("rejects a text over the maximum length without parsing it", () => {
    expect(readChallenge(" ".repeat(2_097_153))).toMatchObject({
      ok: false,
      problems: [{ expected: "at most 2097152 characters" }],
    });
  });
});
