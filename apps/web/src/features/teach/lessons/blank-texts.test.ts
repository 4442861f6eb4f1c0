import { expect, it } from "vitest";
import { sampleLesson, sampleTask } from "../testing/sample-lesson.ts";
import { withoutBlankTexts } from "../../../model/teaching/blank-texts.ts";

it("students receive no hint and no question that the teacher left blank", () => {
  const words = { ...sampleTask.words, hints: ["", "Look right.", "  \n", "Turn left."] };
  const lesson = withoutBlankTexts({
    ...sampleLesson,
    tasks: [{ ...sampleTask, words }, sampleTask],
    survey: [
      { id: "question_1", question: " " },
      { id: "question_2", question: "How was it?" },
    ],
  });
  expect(lesson.tasks[0]?.words.hints).toEqual(["Look right.", "Turn left."]);
  expect(lesson.survey).toEqual([{ id: "question_2", question: "How was it?" }]);
  expect({ ...lesson, tasks: sampleLesson.tasks, survey: [] }).toEqual(sampleLesson);
});
