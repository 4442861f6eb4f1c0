/** How each line of the program stands at the shown moment. */
import { truthOf, type ProgramDocument, type Truth } from "@corridor/program";
import type { LineRef, Snapshot } from "@corridor/protocol";

export interface LineState {
  /** whether this line drives the robot now */
  isDeciding: boolean;
  /** whether a line above it decided, so that it was not read */
  isPassedOver: boolean;
  /** null for a line that does nothing, and before the first snapshot */
  truth: Truth | null;
}

/** The line that drives the robot; null while the program does not drive. */
export function decidingLine(snapshot: Snapshot | null): LineRef | null {
  return snapshot?.driver === "program" ? snapshot.line : null;
}

/** One state a rule, in their order. */
export function lineStates(program: ProgramDocument, snapshot: Snapshot | null): LineState[] {
  const deciding = decidingLine(snapshot);
  return program.rules.map(({ when }, index) => ({
    isDeciding: deciding === index,
    isPassedOver: deciding !== null && deciding !== "default" && index > deciding,
    truth: snapshot === null ? null : truthOf(when, snapshot.sensors),
  }));
}
