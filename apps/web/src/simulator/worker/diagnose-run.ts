/**
 * Diagnoses why the displayed run failed, from the part of the recording before the failure that
 * the program alone drove. In its own file, which loads once the robot drives.
 */
import {
  bumpEvent,
  diagnoseStretch,
  FREE_PLAY_PAST,
  freePlayTask,
  type Diagnosis,
  type LoopNotice,
} from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import type { Recording, Run } from "@corridor/recording";
import { Simulation } from "@corridor/simulation";
import { allowedDiagnosis, type PageTask } from "./diagnosis-task.ts";

/** A diagnosis with the program that drove: it may have been edited on the page since. */
export interface DiagnosedRun {
  program: ProgramDocument;
  diagnosis: Diagnosis;
}

/**
 * The open task. @param isWhole whether the program alone drove since the start
 */
export type TaskOf = (isWhole: boolean) => PageTask;

/**
 * Diagnoses a bump at the newest tick.
 * @param line null if a script drove: then only the facts are given
 */
export function diagnoseBump(
  recording: Recording,
  line: LineRef | null,
  task: TaskOf | null,
): DiagnosedRun | null {
  const { cause, maze, pose, tick, program } = recording.run;
  if (cause === null) return null;
  const diagnosed = line === null ? null : diagnoseAt(recording, "bump", tick, task);
  if (diagnosed !== null) return diagnosed;
  const event = bumpEvent(maze, cause, pose, tick, line);
  return { program, diagnosis: { event, cause: null, fixes: [] } };
}

/**
 * @param failure how the tick ended: a bump, the time limit, or a sign that the robot gets nowhere
 * @param tick tick of the failure; the newest one for a bump
 */
export function diagnoseAt(
  recording: Recording,
  failure: "bump" | "late" | LoopNotice,
  tick: number,
  taskOf: TaskOf | null,
): DiagnosedRun | null {
  const { run } = recording;
  const { cause } = run;
  const playback = recording.playback();
  // A turn that started before an edit belongs to the program that started it.
  const since = recording.newestInputUpTo(failure === "bump" ? (cause?.decidedAt ?? tick) : tick);
  playback.seek(taskOf === null ? Math.max(since, tick - FREE_PLAY_PAST) : since);
  const begin = playback.run;
  // A manoeuvre that another program or driver started is not this program's.
  while (begin.isManoeuvring && begin.decidedAt < begin.tick && begin.tick < tick) {
    playback.step();
  }
  if (begin.tick >= tick || begin.driver !== "program") return null;
  const { maze, program } = begin;
  const robot = new Simulation(maze);
  robot.restore(begin.save().simulation);
  // The trace repeats the decision at the end of this tick.
  robot.apply({ action: "stop" });
  const state = robot.save();
  const task = taskOf?.(begin.tick === 0) ?? freeTask(run, tick);
  const start = { maze, program, state };
  const bumpsBefore = failure === "bump" ? run.bumps - 1 : run.bumps;
  const diagnosis = diagnoseStretch(start, task, tick, failure, bumpsBefore);
  return diagnosis && { program, diagnosis: allowedDiagnosis(diagnosis, task) };
}

/** A goal that was reached before proves nothing about the path after it. */
function freeTask({ maze, goalTick }: Run, tick: number): PageTask {
  const task = { ...freePlayTask(maze, tick), hasBlame: true };
  return goalTick === null ? task : { ...task, newSolvedCheck: null };
}
