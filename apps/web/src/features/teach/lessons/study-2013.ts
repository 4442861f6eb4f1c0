/**
 * The study of 2013 as a lesson: its introduction, its two algorithms and its survey. A class that
 * takes it yields the tables of the paper.
 */
import type { LessonDocument } from "@corridor/challenge";
import type { i18n } from "i18next";
import type { Mission, MissionId } from "../../../model/lessons/missions/mission.ts";
import { missions } from "../../../model/lessons/missions/missions.ts";
import { missionLesson } from "./new-lesson.ts";

/** Missions 1 to 4, the right wall and the farthest distance. */
const studyMissionIds: readonly MissionId[] = [
  "make-it-move",
  "how-far",
  "one-line",
  "first-true-line",
  "right-wall",
  "farthest-distance",
];

/** The questions of the survey, by the columns of the paper's table 9. */
export const studyQuestionIds = [
  "control_flow",
  "navigation",
  "correctness",
  "interaction",
] as const;
type StudyQuestionId = (typeof studyQuestionIds)[number];

export function isStudyQuestion(id: string): id is StudyQuestionId {
  return studyQuestionIds.some((each) => each === id);
}

export const studyMissions: readonly Mission[] = missions.filter(({ id }) =>
  studyMissionIds.includes(id),
);

/**
 * The study in the language of the page.
 * @param words with the namespaces "missions" and "teach" loaded
 */
export function study2013(words: Pick<i18n, "t" | "language">): LessonDocument {
  return {
    format: "corridor/challenge",
    version: 2,
    language: words.language,
    name: words.t("teach:study.name"),
    intro: "",
    order: "any",
    tasks: studyMissions.flatMap((mission) => missionLesson(mission, words).tasks),
    survey: studyQuestionIds.map((id) => ({
      id,
      question: words.t(`teach:study.questions.${id}`),
    })),
  };
}
