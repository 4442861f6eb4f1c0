/** For every wrong answer, the advice before a run does not contradict the verdict after it. */
import { lessonOf, rightsOf, taskOf } from "@corridor/challenge";
import { adviseProgram, causeLine, type Advice, type Cause, type Diagnosis } from "@corridor/coach";
import { describe, expect, it } from "vitest";
import { checkProgram } from "../lessons/testing/check-program.ts";
import { challengeOf } from "../lessons/missions/mission.ts";
import { missions } from "../lessons/missions/missions.ts";
import { answers } from "../lessons/missions/testing/answers.ts";
import { oneStepAnswers, twoStepAnswers } from "../lessons/missions/testing/wrong-answers.ts";
import { concernsReader } from "./advice-in-challenge.ts";

const wrongAnswers = missions.flatMap((mission) => {
  const { solution } = answers[mission.id];
  if (!("rules" in solution)) return [];
  const challenge = challengeOf(mission, mission.id, { task: "", short: "", hints: [] });
  return [...oneStepAnswers(challenge, solution), ...twoStepAnswers(challenge, solution, 97)].map(
    (answer) => ({ id: mission.id, answer, name: answer.name }),
  );
});

/**
 * Causes that agree with the advice on the same line. Advice with `why: "free"` means that the turn
 * uses the wrong sensor.
 */
const sameSaid: Partial<Record<Advice["kind"], readonly Cause["kind"][]>> = {
  "immediate-into-opening": ["not-delayed"],
  "delayed-about-front": ["delayed", "action", "missing", "sensor"],
};

function contradicts(advice: Advice, diagnosis: Diagnosis): boolean {
  const { cause } = diagnosis;
  if (cause === null) return false;
  const said = sameSaid[advice.kind];
  // A line that never decides cannot be the line that decided.
  if (said === undefined) return cause.moment.line === advice.line;
  return causeLine(diagnosis) === advice.line && !said.includes(cause.kind);
}

describe("advice before the run and the verdict after it", () => {
  it.each(wrongAnswers)("agree on $id, $name", ({ answer: { challenge, program } }) => {
    const rights = rightsOf(challenge);
    const { diagnoses } = checkProgram({ task: taskOf(challenge), program });
    const apart = challenge.mazes.flatMap((maze, at) => {
      const diagnosis = diagnoses[at] ?? null;
      if (diagnosis === null) return [];
      return adviseProgram(program, maze)
        .filter((advice) =>
          concernsReader(advice, program, { lesson: lessonOf(challenge), index: 0, rights }),
        )
        .filter((advice) => contradicts(advice, diagnosis));
    });
    expect(apart).toEqual([]);
  });
});
