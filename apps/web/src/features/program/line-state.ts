/** How the lines of the program stand at the shown moment. */
import { truthOf, type Condition } from "@corridor/program";
import type { LineRef, Snapshot } from "@corridor/protocol";
import { truthText } from "./truth-text.ts";

/** The line that drives the robot; null while the program does not drive. */
export function decidingLine(snapshot: Snapshot | null): LineRef | null {
  return snapshot?.driver === "program" ? snapshot.line : null;
}

/** Whether a line above this one decided, so that it was not read. */
export function isPassedOver(index: number, deciding: LineRef | null): boolean {
  return typeof deciding === "number" && index > deciding;
}

/** A line's truth as it is shown: flat, so that a line is only drawn again when this changes. */
export interface ShownTruth {
  isTrue: boolean;
  /** the left side, such as "250.5" */
  left: string;
  /** the right side with its sign, such as "> 60" */
  right: string;
}

/** @returns null for a line that does nothing, and before the first snapshot */
export function shownTruth(
  condition: Condition | null,
  snapshot: Snapshot | null,
): ShownTruth | null {
  if (snapshot === null) return null;
  const truth = truthOf(condition, snapshot.sensors);
  return truth === null ? null : { isTrue: truth.isTrue, ...truthText(truth) };
}
