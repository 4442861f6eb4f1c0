/** A lesson of three tasks for tests, made of missions. */
import { taskOf, type LessonDocument, type LessonTask } from "@corridor/challenge";
import { challengeOf, type MissionId } from "../missions/mission.ts";
import { missions } from "../missions/missions.ts";

const words = { task: "Reach the goal.", short: "Reach the goal", hints: ["Look at front."] };

/** A mission as a task. */
export function sampleTask(id: MissionId, name: string): LessonTask {
  const mission = missions.find((each) => each.id === id);
  if (mission === undefined) throw new Error(`no mission ${id}`);
  return taskOf(challengeOf(mission, name, words));
}

export const sampleLesson: LessonDocument = {
  format: "corridor/challenge",
  version: 2,
  language: null,
  name: "Sensors",
  intro: "Use what the robot sees.",
  order: "any",
  tasks: [
    sampleTask("one-line", "One line"),
    sampleTask("every-maze", "Every maze"),
    sampleTask("side-opening", "Opening"),
  ],
  survey: [],
};
