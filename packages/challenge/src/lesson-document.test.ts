import { describe, expect, it } from "vitest";
import {
  lessonOf,
  oldestDocumentOf,
  parseLesson,
  readLesson,
  readLessonDraft,
} from "./lesson-document.ts";
import type { LessonDocument, LessonTask } from "./lesson-document.ts";
import { sampleChallenge } from "./testing/sample-challenge.ts";
import { sampleLesson, sampleTask } from "./testing/sample-lesson.ts";

const plain = lessonOf(sampleChallenge);
const [task] = plain.tasks as [LessonTask];

function problemsOf(input: unknown): string[] {
  const read = parseLesson(input);
  return read.ok ? [] : read.problems.map(({ path, expected }) => `${path}: ${expected}`);
}

function withTask(change: Partial<LessonTask>): LessonDocument {
  return { ...plain, tasks: [{ ...task, ...change }] };
}

describe("a lesson", () => {
  it("of version 1 is one task, and is written as version 1 again", () => {
    const read = readLesson(JSON.stringify(sampleChallenge));
    expect(read).toEqual({ ok: true, value: plain });
    expect(oldestDocumentOf(plain)).toEqual(sampleChallenge);
  });

  it("of version 2 is read as it was written", () => {
    expect(readLesson(JSON.stringify(sampleLesson))).toEqual({ ok: true, value: sampleLesson });
  });

  it.each<[string, LessonDocument]>([
    ["two tasks", { ...plain, tasks: [task, task] }],
    ["a language", { ...plain, language: "pt-BR" }],
    ["a name", { ...plain, name: "Lesson" }],
    ["an introduction", { ...plain, intro: "Hello" }],
    ["tasks in turn", { ...plain, order: "in turn" }],
    ["a survey", { ...plain, survey: sampleLesson.survey }],
    ["unseen mazes", withTask({ unseen: sampleTask.unseen })],
    ["hidden tools", withTask({ allowed: { ...task.allowed, tools: ["speed"] } })],
    ["hidden help", withTask({ allowed: { ...task.allowed, help: [] } })],
    ["more than 600 seconds", withTask({ checks: { bumps: 0, seconds: 601 } })],
  ])("with %s is written as version 2, and read back", (_, lesson) => {
    const written = oldestDocumentOf(lesson);
    expect(written.version).toBe(2);
    expect(parseLesson(written)).toEqual({ ok: true, value: lesson });
  });

  it.each<[string, unknown, string]>([
    ["a newer version", { ...plain, version: 3 }, "version: version 1 or 2"],
    ["no version", { format: "corridor/challenge" }, "version: version 1 or 2"],
    ["a list instead of an object", [], "a lesson: an object"],
    ["another format", { ...plain, format: "corridor/maze" }, "format: "],
    ["no task", { ...plain, tasks: [] }, "tasks: at least one task"],
    ["13 tasks", { ...plain, tasks: Array.from({ length: 13 }, () => task) }, "tasks: at most 12"],
    ["a wrong language", { ...plain, language: "pt_BR" }, "language: a language tag"],
    ["an unknown field", { ...plain, teacher: "" }, ": "],
    [
      "a repeated question",
      { ...plain, survey: [...sampleLesson.survey, ...sampleLesson.survey] },
      "survey: no duplicate ids",
    ],
    ["a wrong id", { ...plain, survey: [{ id: "1", question: "" }] }, "survey[0].id: 1 to 32"],
    [
      "an unknown tool",
      withTask({ allowed: { ...task.allowed, tools: ["chat" as never] } }),
      ": one",
    ],
    ["3,601 seconds", withTask({ checks: { bumps: 0, seconds: 3_601 } }), "1 to 3600"],
    [
      "fewer lines than those of its program",
      withTask({ allowed: { ...task.allowed, lines: 1 } }),
      "tasks[0].allowed.lines: at least the 2 lines",
    ],
  ])("with %s is refused with the place and what is expected", (_, input, problem) => {
    expect(problemsOf(input).join("\n")).toContain(problem);
  });

  it.each<[string, Partial<NonNullable<LessonTask["unseen"]>>, string]>([
    ["an even side", { columns: 10 }, "unseen.columns: an odd number from 5 to 33"],
    ["a side over 33", { rows: 35 }, "unseen.rows: a whole number from 5 to 33"],
    ["1,001 mazes", { count: 1_001 }, "unseen.count: a whole number from 1 to 1000"],
    ["more to pass than there are", { pass: 6 }, "unseen.pass: at most the value of `count`"],
    ["a seed of seven digits", { seed: 1_000_000 }, "unseen.seed: a whole number"],
  ])("refuses unseen mazes with %s", (_, change, problem) => {
    const unseen = { ...sampleTask.unseen, ...change } as LessonTask["unseen"];
    expect(problemsOf(withTask({ unseen })).join("\n")).toContain(problem);
  });
});

describe("a lesson that is still being written", () => {
  it("may contradict itself, and is read as it was written", () => {
    const [maze] = sampleTask.mazes;
    const tasks = [{ ...sampleTask, mazes: maze === undefined ? [] : [{ ...maze, goals: [] }] }];
    const draft = { ...sampleLesson, tasks };
    expect(parseLesson(draft).ok).toBe(false);
    expect(readLessonDraft(JSON.stringify(draft))).toEqual({ ok: true, value: draft });
  });

  it("has fields within their bounds all the same", () => {
    const read = readLessonDraft(JSON.stringify({ ...sampleLesson, order: "random" }));
    expect(read.ok).toBe(false);
  });
});
