/** Diagnoses why a program fails in a maze of a task. */
import { mazeOf } from "@corridor/challenge";
import { diagnoseProgram, type Diagnosis } from "@corridor/coach";
import { Simulation } from "@corridor/simulation";
import type { AttemptToDiagnose } from "../protocol/pool-messages.ts";
import { allowedDiagnosis, diagnosisTask } from "../worker/diagnosis-task.ts";

/** @returns null if the program passes in the maze */
export function diagnoseAttempt({
  task,
  program,
  maze: at,
  reader,
}: AttemptToDiagnose): Diagnosis | null {
  const maze = mazeOf(task, at);
  const state = new Simulation(maze).save();
  const pageTask = diagnosisTask(task, maze);
  const diagnosis = diagnoseProgram({ maze, program, state }, pageTask);
  if (diagnosis === null || reader === "teacher") return diagnosis;
  return allowedDiagnosis(diagnosis, pageTask);
}
