/** How the lines of the program stand at the shown moment. */
import { causeLine, type Diagnosis } from "@corridor/coach";
import { evaluateCondition, type Condition } from "@corridor/program";
import type { LineRef, Snapshot } from "@corridor/protocol";
import type { RunState } from "../../stores/run-store.ts";
import type { RunEvent } from "../../worker/worker-messages.ts";
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
  const truth = evaluateCondition(condition, snapshot.sensors);
  return truth === null ? null : { isTrue: truth.isTrue, ...truthText(truth) };
}

/** A line's truth by the moment; asked for the same moment again, it is not worked out again. */
export type TruthAt = (snapshot: Snapshot | null) => ShownTruth | null;

export function truthAt(condition: Condition | null): TruthAt {
  let newest: Snapshot | null = null;
  let truth: ShownTruth | null = null;
  return (snapshot) => {
    if (snapshot !== newest) {
      newest = snapshot;
      truth = shownTruth(condition, snapshot);
    }
    return truth;
  };
}

/** How a line stands to the one that drives; notRead: a line above won. */
export type LineStanding = "resting" | "running" | "bumped" | "notRead";

export function lineStanding(
  index: number,
  state: Pick<RunState, "snapshot"> & { event: BumpMoment | null },
): LineStanding {
  if (shownBump(index, state) !== null) return "bumped";
  const deciding = decidingLine(state.snapshot);
  if (deciding === index) return "running";
  return isPassedOver(index, deciding) ? "notRead" : "resting";
}

/** How far the line's manoeuvre is, in whole units for eyes; flat like the truth. */
export interface ShownProgress {
  /** what the part that runs leads to: the turn of a delayed turn, the end of a turn, the way out */
  kind: "approach" | "turn" | "leave";
  /** whole cm or degrees that are left, rounded up: 0 is never shown */
  left: number;
  of: number;
}

/** @returns null when no manoeuvre of this line runs at the shown moment */
export function shownProgress(
  line: LineRef,
  { snapshot, progress }: Pick<RunState, "snapshot" | "progress">,
): ShownProgress | null {
  if (progress === null || progress.kind === "wheels" || decidingLine(snapshot) !== line) {
    return null;
  }
  const { kind, part, parts, of } = progress;
  const left = Math.ceil(progress.left - CRUMB);
  if (kind === "turn") return { kind, left, of };
  return { kind: part < parts - 1 ? "approach" : "leave", left, of };
}

/** Rounding leaves crumbs of a distance; they are none. */
const CRUMB = 1e-6;

/** A bump as its line shows it: how far it came, and how far it would have gone. Whole cm. */
export interface ShownBump {
  /** null when it is not known, as for a bump of the past */
  driven: number | null;
  /** null for a motion that lasts until something else is chosen */
  needed: number | null;
}

/** What of a moment tells of a bump. */
type BumpMoment = Pick<RunEvent, "kind" | "line" | "bumps" | "cause" | "diagnosis">;

/** Why the program's robot touches a wall at the shown moment; null where it does not, or nobody knows why. */
export function shownDiagnosis({
  snapshot,
  event,
}: Pick<RunState, "snapshot"> & { event: BumpMoment | null }): Diagnosis | null {
  if (snapshot === null || !snapshot.bumping || snapshot.driver !== "program") return null;
  // The newest bump is the one that is seen when no other came after or before it.
  const isKnown = event?.kind === "bump" && event.bumps === snapshot.bumps;
  return isKnown ? event.diagnosis : null;
}

/** @returns null unless the robot touches a wall at the shown moment and this line caused that bump */
export function shownBump(
  line: LineRef,
  { snapshot, event }: Pick<RunState, "snapshot"> & { event: BumpMoment | null },
): ShownBump | null {
  const diagnosis = shownDiagnosis({ snapshot, event });
  if (event === null || diagnosis === null || causeLine(diagnosis) !== line) return null;
  const { cause } = event;
  // Another line may have driven into the wall.
  if (cause === null || event.line !== line) return { driven: null, needed: null };
  return { driven: Math.round(cause.driven), needed: cause.needed };
}
