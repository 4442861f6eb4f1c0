/**
 * Checks a program in the given and the unseen mazes of a task, with a diagnosis for each given maze
 * and for the unseen maze where it fails.
 */
import {
  checkMazeOf,
  countMazes,
  mazeOf,
  taskVerdict,
  violationOf,
  type LessonTask,
} from "@corridor/challenge";
import { diagnoseProgram, type Diagnosis } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import { Simulation } from "@corridor/simulation";
import type { CheckAnswer, CheckRequest } from "../protocol/check-request.ts";
import { allowedDiagnosis, diagnosisTask } from "../worker/diagnosis-task.ts";

export function checkProgram({ task, program }: CheckRequest): CheckAnswer {
  const failure = violationOf(task, program);
  if (failure !== null) {
    const refused = { passed: false, failure, failedUnseen: null, unseenFailures: [], mazes: [] };
    return { verdict: refused, diagnoses: [], unseenDiagnosis: null };
  }
  const outcomes = Array.from({ length: countMazes(task) }, (_, at) =>
    checkMazeOf(task, at, program),
  );
  const verdict = taskVerdict(task, outcomes);
  const mazes = outcomes.slice(0, task.mazes.length);
  const diagnoses = mazes.map((each, at) =>
    each.failure === null ? null : diagnosisIn(task, program, at),
  );
  const { failedUnseen } = verdict;
  const unseenDiagnosis =
    failedUnseen === null ? null : diagnosisIn(task, program, task.mazes.length + failedUnseen - 1);
  return { verdict: { ...verdict, mazes }, diagnoses, unseenDiagnosis };
}

/** @param at see `mazeOf` */
function diagnosisIn(task: LessonTask, program: ProgramDocument, at: number): Diagnosis | null {
  const maze = mazeOf(task, at);
  const state = new Simulation(maze).save();
  const pageTask = diagnosisTask(task, maze);
  const diagnosis = diagnoseProgram({ maze, program, state }, pageTask);
  return diagnosis && allowedDiagnosis(diagnosis, pageTask);
}
