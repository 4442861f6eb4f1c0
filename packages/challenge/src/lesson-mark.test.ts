import { describe, expect, it } from "vitest";
import { lessonOf, oldestDocumentOf, parseLesson, type LessonDocument } from "./lesson-document.ts";
import { canonicalJson, lessonMark } from "./lesson-mark.ts";
import { sampleChallenge } from "./testing/sample-challenge.ts";
import { sampleLesson, sampleTask } from "./testing/sample-lesson.ts";

const golden =
  '{"format":"corridor/challenge","intro":"Two lines are enough.","language":"en",' +
  '"name":"Every maze","order":"any","survey":[{"id":"navigation",' +
  '"question":"Did the lines help you to understand navigation?"}],' +
  '"tasks":[{"allowed":{"actions":null,"conditions":["front <","right >"],' +
  '"drivers":["program"],"edits":["condition","number","action","otherwise","order",' +
  '"lines"],"help":null,"lines":3,"maze":false,"tools":null},"checks":{"bumps":0,' +
  '"seconds":120},"goal":{"kind":"reach"},"mazes":[],"name":"First steps","par":{"lines":1,' +
  '"seconds":10},"program":null,"unseen":{"columns":7,"count":5,"kind":"tree","pass":4,' +
  '"rows":7,"seed":7},"words":{"hints":["Look at front."],"short":"Reach the goal",' +
  '"task":"Reach the goal."}}],"version":2}';

/** The same lesson with the fields of all objects in reverse order. */
function reversed(lesson: LessonDocument): unknown {
  return JSON.parse(
    JSON.stringify(lesson, (_, value: unknown) =>
      typeof value === "object" && value !== null && !Array.isArray(value)
        ? Object.fromEntries(Object.entries(value).toReversed())
        : value,
    ),
  );
}

describe("the canonical JSON of a lesson", () => {
  it("has sorted fields and no spaces, and never changes", () => {
    expect(canonicalJson({ ...sampleLesson, tasks: [{ ...sampleTask, mazes: [] }] })).toBe(golden);
  });

  it("does not depend on the order of fields or on the version of the document", () => {
    const read = parseLesson(reversed(sampleLesson));
    expect(read.ok && canonicalJson(read.value)).toBe(canonicalJson(sampleLesson));
    const plain = lessonOf(sampleChallenge);
    const again = parseLesson(oldestDocumentOf(plain));
    expect(again.ok && canonicalJson(again.value)).toBe(canonicalJson(plain));
  });
});

describe("the mark of a lesson", () => {
  it("never changes", () => {
    expect([lessonMark(sampleLesson), lessonMark(lessonOf(sampleChallenge))]).toEqual([
      "ef721a6a8",
      "f851174cc",
    ]);
  });

  it.each<[string, Partial<LessonDocument>]>([
    ["a text", { intro: "Two lines are enough!" }],
    ["a lone surrogate", { intro: "\ud800" }],
    ["the order", { order: "in turn" }],
    ["a limit", { tasks: [{ ...sampleTask, checks: { bumps: 1, seconds: 120 } }] }],
    ["an unseen maze", { tasks: [{ ...sampleTask, unseen: null }] }],
  ])("depends on %s", (_, change) => {
    const mark = lessonMark({ ...sampleLesson, ...change });
    expect(mark).toMatch(/^[0-9a-f]{9}$/);
    expect(mark).not.toBe(lessonMark(sampleLesson));
  });
});
