import { reportOf, type Report } from "@corridor/report";
import { describe, expect, it } from "vitest";
import { lessonWith, taskWith } from "../testing/teacher-task.ts";
import { questionTexts } from "./question-texts.ts";

const lesson = {
  ...lessonWith(taskWith()),
  language: "de",
  survey: [{ id: "question_1", question: "Die Pause?" }],
};
const other = { ...lesson, survey: [{ id: "question_1", question: "Das Video?" }] };

function reportWith(task: string | null, id: string): Report {
  const unknown = {
    seconds: null,
    lines: null,
    attempts: null,
    runs: null,
    bumps: null,
    failedChecks: null,
    hints: null,
    mistakes: null,
  };
  return reportOf({
    work: task === null ? [] : [{ student: null, task, ...unknown }],
    survey: [{ student: null, answers: { [id]: 4 } }],
  });
}

describe("the questions of a report", () => {
  it("are those of the lesson with the same questions and tasks", () => {
    const text = { question: "Die Pause?", language: "de" };
    for (const task of [null, "Straight on"]) {
      expect([...questionTexts(reportWith(task, "question_1"), [lesson])]).toEqual([
        ["question_1", text],
      ]);
    }
  });

  it.each([
    ["another task", reportWith("Turn left", "question_1"), [lesson]],
    ["another question", reportWith("Straight on", "question_2"), [lesson]],
    ["lessons that disagree", reportWith(null, "question_1"), [lesson, other]],
    [
      "a question without a text",
      reportWith(null, "question_1"),
      [{ ...lesson, survey: [{ id: "question_1", question: " " }] }],
    ],
  ])("are not guessed from %s", (_name, report, lessons) => {
    expect(questionTexts(report, lessons).size).toBe(0);
  });
});
