/** Hints and questions that the teacher added but did not write. */
import type { LessonDocument } from "@corridor/challenge";

export function isBlank(text: string): boolean {
  return text.trim() === "";
}

/** The lesson as students receive it: without blank hints and blank questions. */
export function withoutBlankTexts(lesson: LessonDocument): LessonDocument {
  return {
    ...lesson,
    tasks: lesson.tasks.map((task) => ({
      ...task,
      words: { ...task.words, hints: task.words.hints.filter((hint) => !isBlank(hint)) },
    })),
    survey: lesson.survey.filter(({ question }) => !isBlank(question)),
  };
}
