import { lessonOf, type ChallengeDocument } from "@corridor/challenge";
import { describe, expect, it } from "vitest";
import { readLessonText, writeLessonText } from "./lesson-text.ts";
import { sampleLesson } from "./testing/sample-lesson.ts";

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

const lesson = lessonOf(large);

describe("a lesson on the device", () => {
  it("is restored, and takes no more space than its link", () => {
    const text = writeLessonText(lesson);
    expect(text.length).toBeLessThan(400);
    expect(readLessonText(text)).toEqual(lesson);
  });

  it("of several tasks is restored", () => {
    expect(readLessonText(writeLessonText(sampleLesson))).toEqual(sampleLesson);
  });

  it("is read from the formats of earlier versions", () => {
    expect(readLessonText(JSON.stringify(large))).toEqual(lesson);
  });

  it.each(["", "{", "{}", "nonsense"])("is none in %j", (text) => {
    expect(readLessonText(text)).toBeNull();
  });
});
