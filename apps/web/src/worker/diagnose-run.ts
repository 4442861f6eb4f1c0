/**
 * Says why the run on the screen failed: from the stretch of the recording that the program alone drove
 * up to the failure. In a file of its own that comes once the robot drives.
 */
import {
  bumpEvent,
  diagnoseStretch,
  freePlayTask,
  type Diagnosis,
  type DiagnosisTask,
} from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import type { Recording, Run } from "@corridor/recording";
import { Simulation } from "@corridor/simulation";

/** Without a task a failure is looked into from a minute before it. */
const MOST_TICKS = 3600;
/** How long after a failure a changed program may take to reach the goal of a maze without a task. */
const GOAL_TICKS = 3600;

/** A diagnosis with the program that drove: it may have been edited on the page meanwhile. */
export interface DiagnosedRun {
  program: ProgramDocument;
  diagnosis: Diagnosis;
}

/** The task of the open challenge. @param isWhole whether the program alone drove since the start */
export type TaskOf = (isWhole: boolean) => DiagnosisTask;

/** The newest tick ended in a bump. @param line null where a script drove: then only the facts are given */
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
 * @param kind what the tick ended in; stuck: the robot gets nowhere; late: the time is over
 * @param tick of the failure; the newest one for a bump
 */
export function diagnoseAt(
  recording: Recording,
  kind: "bump" | "stuck" | "late",
  tick: number,
  taskOf: TaskOf | null,
): DiagnosedRun | null {
  const { run } = recording;
  const { cause } = run;
  const playback = recording.playback();
  // A turn that began before an edit belongs to the program that began it.
  const since = recording.newestInputUpTo(kind === "bump" ? (cause?.decidedAt ?? tick) : tick);
  playback.goTo(taskOf === null ? Math.max(since, tick - MOST_TICKS) : since);
  const begin = playback.run;
  // A manoeuvre that another program or driver began is not this program's.
  while (begin.isManoeuvring && begin.decidedAt < begin.tick && begin.tick < tick) {
    playback.step();
  }
  if (begin.tick >= tick || begin.driver !== "program") return null;
  const { maze, program } = begin;
  const robot = new Simulation(maze);
  robot.restore(begin.save().simulation);
  // The decision that was taken at the end of this tick is taken once more by the trace.
  robot.apply({ action: "stop" });
  const state = robot.save();
  const task = taskOf?.(begin.tick === 0) ?? freeTask(run, tick);
  const diagnosis = diagnoseStretch({ maze, program, state }, task, tick, kind);
  return diagnosis && { program, diagnosis };
}

/** A goal that was reached before proves nothing of the way after it. */
function freeTask({ maze, goalTick }: Run, tick: number): DiagnosisTask {
  const task = freePlayTask(maze, tick + GOAL_TICKS);
  return goalTick === null ? task : { ...task, newSolvedCheck: null };
}
