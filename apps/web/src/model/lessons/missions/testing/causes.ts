/** The missions with a program, and the causes that the diagnosis names for their answers. */
import { taskOf } from "@corridor/challenge";
import type { Cause } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import { checkProgram } from "../../testing/check-program.ts";
import { challengeOf } from "../mission.ts";
import { missions } from "../missions.ts";
import { answers } from "./answers.ts";

const noWords = { task: "", short: "", hints: [] };

/** Challenge and solution of each mission with a program. */
export const solved = missions.flatMap((mission) => {
  const { solution } = answers[mission.id];
  const challenge = challengeOf(mission, mission.id, noWords);
  return "rules" in solution ? [{ id: mission.id, challenge, solution }] : [];
});

/** The cause in each maze of a mission; null without one. */
export function causes(id: string, program: ProgramDocument): (Cause | null)[] {
  const mission = solved.find((each) => each.id === id);
  if (mission === undefined) throw new Error("no such mission");
  const { diagnoses } = checkProgram({ task: taskOf(mission.challenge), program });
  return diagnoses.map((each) => each?.cause ?? null);
}
