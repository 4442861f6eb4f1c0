import type { Work } from "@corridor/report";
import { expect, it } from "vitest";
import { studentRows } from "./student-rows.ts";

function workOf(student: string | null, task: string, change: Partial<Work> = {}): Work {
  return {
    student,
    task,
    seconds: 60,
    lines: 2,
    attempts: 1,
    runs: 2,
    bumps: 3,
    failedChecks: 0,
    hints: null,
    mistakes: null,
    ...change,
  };
}

it("each student has one row with the times of all tasks and the sums of the counts", () => {
  const work = [
    workOf("Juniper", "One"),
    workOf("Comet", "Two", { seconds: null, attempts: null }),
    workOf("Juniper", "Two", { seconds: 90, bumps: 4, hints: 1 }),
  ];
  const survey = ["Juniper", "Pixel"].map((student) => ({ student, answers: {} }));
  expect(studentRows({ work, survey }, ["One", "Two"])).toEqual([
    {
      student: "Juniper",
      times: [60, 90],
      sums: { attempts: 2, runs: 4, bumps: 7, hints: 1 },
    },
    {
      student: "Comet",
      times: [null, "unsolved"],
      sums: { attempts: null, runs: 2, bumps: 3, hints: null },
    },
    {
      student: "Pixel",
      times: [null, null],
      sums: { attempts: null, runs: null, bumps: null, hints: null },
    },
  ]);
});

it("students without a name have the rows of their tables, by number", () => {
  const work = [
    workOf(null, "One", { seconds: 30 }),
    workOf(null, "One", { seconds: null }),
    workOf("Juniper", "One"),
    workOf(null, "Two", { seconds: 240 }),
  ];
  const rows = studentRows({ work, survey: [] }, ["One", "Two"]);
  expect(rows.map(({ student, times }) => [student, ...times])).toEqual([
    ["Juniper", 60, null],
    ["1", 30, 240],
    ["2", "unsolved", null],
  ]);
});

it("a survey without names has no rows of students", () => {
  const survey = [{ student: null, answers: { navigation: 4 } as const }];
  expect(studentRows({ work: [], survey }, [])).toEqual([]);
});
