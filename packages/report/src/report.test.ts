/** The figures of the thesis, from its own data files. */
import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { reportOf, type Report } from "./report.ts";
import { readStudyCsv } from "./study-csv.ts";
import type { Study, Work } from "./study.ts";

function paperStudy(file: string): Study {
  const read = readStudyCsv(readFileSync(new URL(`testing/${file}`, import.meta.url), "utf8"));
  if (!read.ok) throw new Error("the file of the paper is invalid");
  return read.value;
}

function clock(seconds: number | null): string {
  const whole = Math.round(seconds ?? Number.NaN);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

describe("the study of 2013", () => {
  const times = reportOf(paperStudy("table-10-times.csv"));

  it.each([
    {
      task: "right_wall",
      time: { mean: "5:17", median: "4:30", deviation: "3:53", shortest: "0:30", longest: "14:00" },
      lines: 2,
      paper: { menus: 5, misprint: null },
      first: [30, 30, 40],
    },
    {
      task: "farthest_distance",
      time: { mean: "3:48", median: "3:53", deviation: "2:15", shortest: "0:45", longest: "9:30" },
      lines: 3,
      paper: { menus: 7, misprint: "3:38" },
      first: [240, 240, 360],
    },
  ])("has the times and lines of tables 6 and 10: $task", (expected) => {
    const task = times.tasks.find((each) => each.task === expected.task);
    const { mean, median, deviation, shortest, longest } = task?.time ?? missing();
    expect([times.students, task?.opened, task?.solved]).toEqual([28, 28, 28]);
    expect(
      Object.fromEntries(
        Object.entries({ mean, median, deviation, shortest, longest }).map(([name, value]) => [
          name,
          clock(value),
        ]),
      ),
    ).toEqual(expected.time);
    expect([task?.lines, task?.paper]).toEqual([expected.lines, expected.paper]);
    expect(task?.bars.slice(0, 3).map(({ seconds }) => seconds)).toEqual(expected.first);
  });

  it("has the answers of table 9, and the means and mistakes of table 7", () => {
    const mistakes = new Map([
      ["control_flow", 1],
      ["navigation", 3],
      ["correctness", 3],
    ]);
    const { students, questions } = reportOf(paperStudy("table-9-survey.csv"), mistakes);
    expect(students).toBe(28);
    expect(
      questions.map(({ id, counts, mean, mistakes: found, skipped }) => [
        id,
        counts,
        mean?.toFixed(1),
        found && (found.share * 100).toFixed(1),
        skipped,
      ]),
    ).toEqual([
      ["control_flow", [0, 3, 5, 9, 11], "4.0", "3.6", 0],
      ["navigation", [0, 1, 4, 9, 14], "4.3", "10.7", 0],
      ["correctness", [1, 2, 5, 11, 9], "3.9", "10.7", 0],
      ["interaction", [0, 1, 6, 9, 12], "4.1", null, 0],
    ]);
  });
});

describe("another class", () => {
  const unknown = {
    student: null,
    lines: null,
    attempts: null,
    runs: null,
    bumps: null,
    failedChecks: null,
    hints: null,
    mistakes: null,
  };
  const reportOn = (work: (Partial<Work> & Pick<Work, "seconds">)[]): Report =>
    reportOf({
      work: work.map((each) => ({ ...unknown, task: "right_wall", ...each })),
      survey: [],
    });

  it("counts only solved tasks in the times, and keeps the lines of the paper to the paper", () => {
    const [task] = reportOn([{ seconds: 60 }, { seconds: null }, { seconds: 120 }]).tasks;
    expect(task).toMatchObject({ opened: 3, solved: 2, lines: null, paper: null });
    expect(task?.time).toMatchObject({ mean: 90, shortest: 60, longest: 120 });
  });

  it("has no mean of one student", () => {
    const report = reportOn([{ seconds: 60, lines: 2, attempts: 4 }]);
    expect(report.students).toBe(1);
    expect(report.tasks[0]).toMatchObject({
      time: { mean: null, median: null, deviation: null, shortest: 60, longest: 60 },
      lines: "too few",
      perStudent: { attempts: "too few", runs: null },
    });
  });

  it("has the mean of the lines and counts of its students", () => {
    const [task] = reportOn([
      { seconds: 60, lines: 2, hints: 0 },
      { seconds: 70, lines: 3, hints: 3 },
    ]).tasks;
    expect(task).toMatchObject({ lines: 2.5, perStudent: { hints: 1.5, bumps: null } });
  });

  it("counts the students with a mistake, of all students, if the class counted mistakes", () => {
    const students = ["Juniper", "Comet", "Pixel"].map((student) => ({ student, seconds: 60 }));
    const [juniper, comet, pixel] = students as [Work, Work, Work];
    const report = reportOn([
      { ...juniper, mistakes: 4 },
      { ...comet, mistakes: 0 },
      { ...pixel, task: "other" },
    ]);
    expect(report.tasks.map(({ mistaken }) => mistaken)).toEqual([
      { students: 1, share: 1 / 3 },
      null,
    ]);
  });

  it("counts a student once in several tasks", () => {
    const work = [
      { student: "Juniper", seconds: 60 },
      { student: "Juniper", seconds: 60, task: "other" },
      { student: "Comet", seconds: null },
    ];
    expect(reportOn(work).students).toBe(2);
  });

  it("has the same students in every task: who opened none or gave no answer is one of them", () => {
    const table = [
      "student,task,seconds,navigation",
      "Juniper,1,60,",
      "Comet,1,,",
      "Comet,2,90,",
      "Juniper,,,4",
      "Comet,,,",
      "Pixel,,,",
    ];
    const read = readStudyCsv(table.join("\n"));
    if (!read.ok) throw new Error("the table is invalid");
    const { students, tasks, questions } = reportOf(read.value);
    expect(students).toBe(3);
    expect(tasks.map(({ opened, solved }) => [opened, solved])).toEqual([
      [2, 1],
      [1, 1],
    ]);
    expect(questions[0]).toMatchObject({ counts: [0, 0, 0, 1, 0], skipped: 2 });
  });
});

function missing(): never {
  throw new Error("the report lacks the task");
}
