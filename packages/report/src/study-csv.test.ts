import { describeProblem } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { reportOf } from "./report.ts";
import { joinStudies, MAX_CSV_LENGTH, MAX_ROWS, readStudyCsv, studyCsv } from "./study-csv.ts";
import { answerSchema, type Study } from "./study.ts";

function problemsOf(text: string): string[] {
  const read = readStudyCsv(text);
  return read.ok ? [] : read.problems.map(describeProblem);
}

const count = fc.option(fc.integer({ min: 0, max: 200 }));
const label = fc
  .string({ unit: "grapheme", minLength: 1, maxLength: 20 })
  .filter((text) => text.trim() === text);
const work = fc.record({
  student: fc.option(label),
  task: label,
  seconds: fc.option(fc.integer({ min: 0, max: 4_320_000 }).map((tenths) => tenths / 100)),
  lines: count,
  attempts: count,
  runs: count,
  bumps: count,
  failedChecks: count,
  hints: count,
  mistakes: count,
});
const answers = fc.record({
  student: fc.option(label),
  answers: fc.record({
    navigation: fc.constantFrom(...answerSchema.unwrap().values),
    other: fc.constantFrom(null, ...answerSchema.unwrap().values),
  }),
});
/** Ids of questions, also those that are names of columns, or that these are written as. */
const questionId = fc.oneof(
  fc.stringMatching(/^[a-z][a-z0-9_]{0,31}$/),
  fc.stringMatching(
    /^(answer_){0,2}(student|task|seconds|lines|attempts|runs|bumps|failed_checks|hints|mistakes)$/,
  ),
  fc.constantFrom("constructor", "right_wall_seconds"),
);

describe("a study", () => {
  it("is read as it was written", () => {
    const studies = fc.record({
      work: fc.array(work, { maxLength: 5 }),
      survey: fc.array(answers, { maxLength: 5 }),
    });
    fc.assert(
      fc.property(studies, (study: Study) => {
        const read = readStudyCsv(studyCsv(study).join("\r\n"));
        expect(read).toEqual({ ok: true, value: study });
      }),
    );
  });

  it("is read as it was written, whatever ids its questions have", () => {
    const surveys = fc.uniqueArray(questionId, { maxLength: 8 }).chain((ids) =>
      fc.array(
        fc.record({
          student: label,
          answers: fc.record(
            Object.fromEntries(
              ids.map((id) => [id, fc.constantFrom(null, 1 as const, 5 as const)]),
            ),
          ),
        }),
        { minLength: 1, maxLength: 3 },
      ),
    );
    fc.assert(
      fc.property(surveys, (survey) => {
        const read = readStudyCsv(studyCsv({ work: [], survey }).join("\r\n"));
        expect(read).toEqual({ ok: true, value: { work: [], survey } });
      }),
    );
  });

  it("has the answers to a question in a column of their own, also beside a count", () => {
    const given = { hints: 5, answer_hints: 4, navigation: 3 } as const;
    const lines = studyCsv({ work: [], survey: [{ student: "Juniper", answers: given }] });
    expect(lines[0]).toMatch(/,hints,mistakes,answer_hints,answer_answer_hints,navigation$/);
    expect(problemsOf([lines[0], "Juniper,,,,,,,,,,6,,"].join("\n"))).toEqual([
      expect.stringMatching(/^row 2, answer_hints: found 6/),
    ]);
  });

  it("has no answer to a question of another table, whatever its id", () => {
    const survey = [
      { student: "Juniper", answers: { constructor: 5 } },
      { student: "Cedar", answers: { navigation: 3 } },
    ] as const;
    const read = readStudyCsv(studyCsv({ work: [], survey }).join("\n"));
    expect(read.ok && read.value.survey[1]?.answers).toEqual({ constructor: null, navigation: 3 });
    const [question] = reportOf({ work: [], survey }).questions;
    expect(question).toMatchObject({ id: "constructor", counts: [0, 0, 0, 0, 1], skipped: 1 });
  });

  it("is read with decimal commas and semicolons, as spreadsheets of many languages write it", () => {
    const read = readStudyCsv("student;task;seconds\r\nJuniper;1;12,5\r\n");
    expect(read.ok && read.value.work[0]).toMatchObject({ student: "Juniper", seconds: 12.5 });
  });

  it("combines times and answers, and refuses a second row of a student and task", () => {
    const read = (text: string): Study => {
      const result = readStudyCsv(text);
      if (!result.ok) throw new Error(problemsOf(text).join("\n"));
      return result.value;
    };
    const times = read("a_seconds\n1\n2\n");
    const survey = read("navigation\n5\n");
    const joined = joinStudies([times, survey]);
    expect(joined.ok && [joined.value.work.length, joined.value.survey.length]).toEqual([2, 1]);
    const named = read("student,task,seconds\nJuniper,1,5\n");
    expect(joinStudies([named, named])).toMatchObject({
      problems: [{ found: "two rows of Juniper and 1" }],
    });
  });
});

describe("an invalid table", () => {
  it.each([
    { name: "a text", text: "hello world", says: ["row 1: found the columns hello world"] },
    { name: "JSON", text: '{"format":"corridor/challenge"}', says: ["row 1: found the columns {"] },
    { name: "nothing", text: "", says: ["document: found text that is not CSV"] },
    {
      name: "wrong numbers",
      text: "student,task,seconds,lines\nA,1,soon,2\nB,1,-5,1.5\n",
      says: [
        'row 2, seconds: found "soon", expected seconds',
        'row 3, seconds: found "-5"',
        "row 3, lines: found 1.5, expected a whole number of lines",
      ],
    },
    {
      name: "a time beyond 12 hours",
      text: "a_seconds\n43201\n",
      says: ["row 2, a_seconds: found 43201, expected seconds, 0 to 43200"],
    },
    {
      name: "an answer of 6",
      text: "navigation\n6\n",
      says: ["row 2, navigation: found 6, expected an answer from 1"],
    },
    {
      name: "an answer in a row with a task",
      text: "student,task,seconds,navigation\nA,1,5,3\n",
      says: ['row 2, task: found "1", expected no task'],
    },
    {
      name: "a repeated column",
      text: "navigation,navigation\n1,2\n",
      says: ['row 1: found two columns "navigation"'],
    },
    {
      name: "an unknown column",
      text: "student,task,Real name\nA,1,x\n",
      says: ['row 1: found the column "Real name"'],
    },
    { name: "a prototype's name", text: "student,task,__proto__\nA,,5\n", says: ["row 1: "] },
    {
      name: "too many rows",
      text: `a_seconds\n${"1\n".repeat(MAX_ROWS + 1)}`,
      says: [`document: found more than ${MAX_ROWS} rows`],
    },
    {
      name: "too long a text",
      text: "x".repeat(MAX_CSV_LENGTH + 1),
      says: [`document: found ${MAX_CSV_LENGTH + 1} characters`],
    },
  ])("is reported with its place and what is expected: $name", ({ text, says }) => {
    const problems = problemsOf(text);
    expect(problems).toHaveLength(says.length);
    for (const [index, start] of says.entries()) {
      expect(problems[index]?.slice(0, start.length)).toBe(start);
    }
  });

  it("reports at most 20 problems", () => {
    expect(problemsOf(`a_seconds\n${"x\n".repeat(500)}`)).toHaveLength(20);
  });

  it("never throws", () => {
    fc.assert(
      fc.property(fc.string({ unit: "binary", maxLength: 200 }), (text) => void readStudyCsv(text)),
    );
  });
});
