/**
 * The line that is lit at a tick of the run. If the program was a different one then, it is the
 * line that the newest program would choose: what would happen here. Where the run has ended, it is
 * the line that drove last, because no line decides there.
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
 * The line that drove to the end of the run: into a wall, to the goal, or until the time of the
 * challenge was over. The run must rest at its newest tick.
 * @param isLate whether the time of the challenge ended with this tick
 * @returns null if the run can go on: this tick ended nothing, or an input has changed the run since
 */
export function lastLine(run: Run, isLate: boolean): LineRef | null {
  const hasEnded = run.cause !== null || run.goalTick === run.tick || isLate;
  return hasEnded ? run.drivenBy : null;
}

/** Whether another program than the newest decided, so that the newest decides again. */
export function isDecidedAnew(run: Run, newest: NewestProgram): boolean {
  const isFree = !run.isManoeuvring || run.decidedAt === run.tick;
  return run.driver === "program" && run.program !== newest.document && isFree;
}
