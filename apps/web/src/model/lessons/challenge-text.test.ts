import type { ChallengeDocument } from "@corridor/challenge";
import { describe, expect, it } from "vitest";
import { readChallengeText, writeChallengeText } from "./challenge-text.ts";

const large: ChallengeDocument = {
  format: "corridor/challenge",
  version: 1,
  name: "Far and wide",
  words: { task: "Cross the field.", short: "Cross the field", hints: ["East."] },
  mazes: Array.from({ length: 10 }, (_, at) => ({
    format: "corridor/maze",
    version: 1,
    name: "Field",
    blocks: Array.from({ length: 256 }, () => ".".repeat(256)),
    start: { column: 0, row: at, heading: "east" },
    goals: [{ column: 255, row: at }],
  })),
  program: null,
  goal: { kind: "reach" },
  allowed: {
    drivers: ["program"],
    lines: 1,
    conditions: null,
    actions: null,
    edits: ["lines"],
    maze: false,
  },
  checks: { bumps: 0, seconds: 60 },
  par: null,
};

describe("a challenge on the device", () => {
  it("is restored, and takes no more space than its link", () => {
    const text = writeChallengeText(large);
    expect(text?.length).toBeLessThan(400);
    expect(readChallengeText(text ?? "")).toEqual(large);
  });

  it("reads the format of earlier versions", () => {
    expect(readChallengeText(JSON.stringify(large))).toEqual(large);
  });

  it.each(["", "{", "{}", "nonsense"])("is none in %j", (text) => {
    expect(readChallengeText(text)).toBeNull();
  });
});
