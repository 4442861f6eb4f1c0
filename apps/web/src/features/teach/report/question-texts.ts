/** Finds the texts of a report's questions: its tables contain only their ids. */
import type { LessonDocument } from "@corridor/challenge";
import type { Report } from "@corridor/report";

export interface QuestionText {
  question: string;
  /** BCP 47 tag; null: the language of the page */
  language: string | null;
}

/**
 * The texts by the ids of the questions. A lesson has asked them if it has all questions and tasks of
 * the report. Ids such as `question_1` repeat, so a text on which such lessons disagree is left out.
 * @param lessons that the device knows
 */
export function questionTexts(
  { questions, tasks }: Pick<Report, "questions" | "tasks">,
  lessons: readonly LessonDocument[],
): ReadonlyMap<string, QuestionText> {
  const asked = lessons.filter(
    (lesson) =>
      questions.every(({ id }) => lesson.survey.some((each) => each.id === id)) &&
      tasks.every(({ task }) => lesson.tasks.some(({ name }) => name === task)),
  );
  const texts = new Map<string, QuestionText>();
  for (const { id } of questions) {
    const [first, ...others] = asked.flatMap(({ survey, language }) =>
      survey.filter((each) => each.id === id).map(({ question }) => ({ question, language })),
    );
    if (first === undefined || first.question.trim() === "") continue;
    if (others.every(({ question }) => question === first.question)) texts.set(id, first);
  }
  return texts;
}
