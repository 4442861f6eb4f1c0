/**
 * Which line is lit at a moment of the run. Where the program was another one then, it is the line that the
 * newest program would choose there: what would happen here.
 */
import type { CompiledProgram, ProgramDocument } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import type { Run } from "@corridor/recording";

/** The newest program, whole and compiled. */
export interface NewestProgram {
  document: ProgramDocument;
  compiled: CompiledProgram;
}

/** @returns null unless a program drives; also while a manoeuvre of another program than the newest runs */
export function shownLine(run: Run, newest: NewestProgram): LineRef | null {
  if (run.driver !== "program" || run.program === newest.document) return run.line;
  if (!isDecidedAnew(run, newest)) return null;
  const rule = newest.compiled.decide(run.readings);
  return rule < 0 ? "default" : rule;
}

/** Whether the moment was decided by another program than the newest, which would decide here too. */
export function isDecidedAnew(run: Run, newest: NewestProgram): boolean {
  const isFree = !run.isManoeuvring || run.decidedAt === run.tick;
  return run.driver === "program" && run.program !== newest.document && isFree;
}
