/**
 * The line that is lit at a tick of the run. If the program was a different one then, it is the
 * line that the newest program would choose: what would happen here.
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

/** Whether another program than the newest decided, so that the newest decides again. */
export function isDecidedAnew(run: Run, newest: NewestProgram): boolean {
  const isFree = !run.isManoeuvring || run.decidedAt === run.tick;
  return run.driver === "program" && run.program !== newest.document && isFree;
}
