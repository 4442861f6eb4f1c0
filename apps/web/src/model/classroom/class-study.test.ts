import { MAX_NAME_LENGTH } from "@corridor/maze";
import { joinStudies, readStudyCsv, studyCsv } from "@corridor/report";
import fc from "fast-check";
import { expect, it } from "vitest";
import { sampleLesson } from "../lessons/testing/sample-lesson.ts";
import { studyOf } from "./class-study.ts";
import { seenStudent } from "./testing/seen-student.ts";
import type { Verifications } from "./verifier.ts";

const claim = { code: "x", activeAt: 130_900, lines: 2, attempts: 3 };
const work = {
  openedAt: 10_000,
  claims: [claim],
  attempts: 4,
  runs: 3,
  bumps: 2,
  failedChecks: 1,
  hints: 1,
  mistakes: 1,
  failures: [],
};
const lesson = { ...sampleLesson, survey: [{ id: "navigation", question: "How much?" }] };
const students = [
  seenStudent(1, {
    tasks: [
      { ...work, task: 1 },
      { ...work, task: 2 },
    ],
    answers: { navigation: 5, other: 3 },
  }),
  seenStudent(2),
];
const passes = { kind: "passes", claim, attempt: [] } as const;
const verifications: Verifications = new Map([[1, new Map([[1, passes]])]]);

it("the table of a class has verified times as its clocks show them, and the report reads it", () => {
  const study = studyOf({
    lesson,
    students,
    verifications,
    nameOf: ({ student }) => `Team ${student}`,
    taskName: (task) => `Task ${task}`,
  });
  expect(study.work).toMatchObject([
    { student: "Team 1", task: "One line", seconds: 120, lines: 2, attempts: 4 },
    { student: "Team 1", task: "Every maze", seconds: null, lines: null, failedChecks: 1 },
  ]);
  expect(study.survey).toEqual([
    { student: "Team 1", answers: { navigation: 5 } },
    { student: "Team 2", answers: { navigation: null } },
  ]);
  expect(readStudyCsv(studyCsv(study).join("\r\n"))).toEqual({ ok: true, value: study });
});

it("tasks with equal or without names have different labels", () => {
  const [task] = sampleLesson.tasks;
  if (task === undefined) throw new Error("no task");
  const tasks = [task, task, { ...task, name: " " }];
  const all = [1, 2, 3].map((number) => ({ ...work, task: number }));
  const study = studyOf({
    lesson: { ...lesson, tasks },
    students: [seenStudent(1, { tasks: all })],
    verifications: new Map(),
    nameOf: () => "Juniper",
    taskName: (number) => `Task ${number}`,
  });
  expect(study.work.map((row) => row.task)).toEqual(["One line", "Task 2: One line", "Task 3"]);
});

it("a report can be read again, whatever names the tasks and ids the questions have", () => {
  const [task] = sampleLesson.tasks;
  if (task === undefined) throw new Error("no task");
  const names = fc.array(
    fc.oneof(
      fc.string({ maxLength: MAX_NAME_LENGTH }),
      fc.constantFrom("", " ", "A", "Task 2", "Task 2: A", "=1", "'", "a\nb"),
      fc.constantFrom("a", "\u{1F916}").map((each) => each.repeat(50).padEnd(MAX_NAME_LENGTH, "b")),
    ),
    { minLength: 1, maxLength: 12 },
  );
  const ids = fc.uniqueArray(
    fc.oneof(
      fc.stringMatching(/^[a-z][a-z0-9_]{0,31}$/),
      fc.constantFrom("hints", "answer_hints", "student", "constructor"),
    ),
    { maxLength: 8 },
  );
  fc.assert(
    fc.property(names, ids, (named, asked) => {
      const study = studyOf({
        lesson: {
          ...sampleLesson,
          tasks: named.map((name) => ({ ...task, name })),
          survey: asked.map((id) => ({ id, question: "How much?" })),
        },
        students: [
          seenStudent(1, {
            tasks: named.map((_, at) => ({ ...work, task: at + 1 })),
            answers: Object.fromEntries(asked.slice(1).map((id) => [id, 4])),
          }),
        ],
        verifications: new Map(),
        nameOf: () => "Juniper",
        taskName: (number) => `Task ${number}`,
      });
      expect(readStudyCsv(studyCsv(study).join("\r\n"))).toEqual({ ok: true, value: study });
      expect(joinStudies([study]).ok).toBe(true);
    }),
  );
});
