/**
 * The line that is lit at a tick of the run. If the program was a different one then, it is the
 * line that the newest program would choose: what would happen here. At a wall and at the goal, it is
 * the line that drove there, because no line decides on what the robot reads there. Where only the
 * time of a challenge is over, the robot can go on, and the line is the one that decides there, on
 * the readings that the page displays.
 */
import type { CompiledProgram, ProgramDocument } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import type { Run } from "@corridor/recording";

/** The newest program, as a document and compiled. */
export interface NewestProgram {
  document: ProgramDocument;
  compiled: CompiledProgram;
}

/**
 * @returns null unless a program drives; also while a manoeuvre of another program than the newest
 *   runs
 */
export function displayedLine(run: Run, newest: NewestProgram): LineRef | null {
  if (run.driver !== "program" || run.program === newest.document) return run.line;
  if (!isDecidedAnew(run, newest)) return null;
  const rule = newest.compiled.decide(run.readings);
  return rule < 0 ? "default" : rule;
}

/**
 * The line that drove to the end of the run: into a wall or to the goal. The run must rest at its
 * newest tick.
 * @returns null if the run can go on: this tick ended nothing, or an input has changed the run since
 */
export function lastLine(run: Run): LineRef | null {
  const hasEnded = run.cause !== null || run.goalTick === run.tick;
  return hasEnded ? run.drivenBy : null;
}

/** Whether another program than the newest decided, so that the newest decides again. */
export function isDecidedAnew(run: Run, newest: NewestProgram): boolean {
  const isFree = !run.isManoeuvring || run.decidedAt === run.tick;
  return run.driver === "program" && run.program !== newest.document && isFree;
}
