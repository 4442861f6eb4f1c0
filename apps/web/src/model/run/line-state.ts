/** State of the program's lines at the displayed tick. */
import { causeLine, type Diagnosis } from "@corridor/coach";
import {
  evaluateCondition,
  isSameRule,
  type Condition,
  type ProgramDocument,
  type Rule,
} from "@corridor/program";
import type { LineRef, PlainAction, Snapshot } from "@corridor/protocol";
import type { RunState } from "./run-store.ts";
import type { RunEvent } from "../../simulator/protocol/worker-messages.ts";
import { truthText } from "./truth-text.ts";

/**
 * The line that drives the robot, or that drove last where the run has ended; null while the program
 * does not drive. Everything on the page that names the line of the displayed tick asks here.
 */
export function decidingLine(snapshot: Snapshot | null): LineRef | null {
  return snapshot?.driver === "program" ? snapshot.line : null;
}

/** Whether a line above this one decided, so that this line was not read. */
export function isPassedOver(index: number, deciding: LineRef | null): boolean {
  return typeof deciding === "number" && index > deciding;
}

/**
 * A line's truth as it is displayed. A flat object, so that a line renders only when a field
 * changes.
 */
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

/** A line's truth in a snapshot. Memoizes the truth of the newest snapshot. */
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

/** Whether this line drives at the displayed tick while the run goes on. */
export function isDriving(line: LineRef, snapshot: Snapshot | null): boolean {
  return snapshot?.state === "running" && decidingLine(snapshot) === line;
}

/** A line's state relative to the deciding line. `notRead`: a line above it decided. */
export type LineState = "resting" | "running" | "bumped" | "notRead";

/** @param rule what the line says now */
export function lineStateOf(
  index: number,
  rule: Rule,
  state: Pick<RunState, "snapshot" | "hasEnded"> & { event: BumpEvent | null },
): LineState {
  if (shownBump(index, rule, state) !== null) return "bumped";
  const deciding = decidingLine(state.snapshot);
  if (deciding === index) return isDriving(index, state.snapshot) ? "running" : "resting";
  // Where the run has ended, no line decided on these readings, so none was passed over.
  return !state.hasEnded && isPassedOver(index, deciding) ? "notRead" : "resting";
}

/** The progress of the line's manoeuvre, in whole units for display. Flat like `ShownTruth`. */
export interface ShownProgress {
  /**
   * the current part: `approach` comes before a delayed turn, `turn` is the turn, `leave` comes
   * after it
   */
  kind: "approach" | "turn" | "leave";
  /** remaining cm or degrees, rounded up; the page never shows 0 */
  left: number;
  of: number;
}

/**
 * @param line null: a line of an earlier program
 * @returns null if no manoeuvre of this line runs at the displayed tick
 */
export function shownProgress(
  line: LineRef | null,
  { snapshot, progress }: Pick<RunState, "snapshot" | "progress">,
): ShownProgress | null {
  if (progress === null || progress.kind === "wheels" || decidingLine(snapshot) !== line) {
    return null;
  }
  const { kind, part, parts, of } = progress;
  const left = Math.ceil(progress.left - EPSILON);
  if (kind === "turn") return { kind, left, of };
  return { kind: part < parts - 1 ? "approach" : "leave", left, of };
}

/** Allows for rounding errors in a distance. */
const EPSILON = 1e-6;

/**
 * Whether the deciding line decided on the displayed readings. A manoeuvre that has begun was decided
 * on earlier readings, and so was the motion that ended the run.
 */
export function isDecidedHere({ progress, hasEnded }: Pick<RunState, "progress" | "hasEnded">) {
  if (hasEnded) return false;
  return progress === null || (progress.part === 0 && progress.left > progress.of - EPSILON);
}

/**
 * A bump as its line displays it: the distance driven, and the distance needed, in whole cm. Both
 * are null for a motion without a distance: several lines may have chosen it in turn.
 */
export interface ShownBump {
  driven: number | null;
  needed: number | null;
}

/** The part of a run event that describes a bump. */
type BumpEvent = Pick<RunEvent, "kind" | "line" | "bumps" | "cause" | "diagnosis" | "program">;

/**
 * Why the robot, driven by the program, touches a wall at the displayed tick; null if it does not,
 * or if the cause is unknown.
 */
export function shownDiagnosis({
  snapshot,
  event,
}: Pick<RunState, "snapshot"> & { event: BumpEvent | null }): Diagnosis | null {
  if (snapshot === null || !snapshot.bumping || snapshot.driver !== "program") return null;
  // With equal counts, the displayed bump is the newest one.
  const isKnown = event?.kind === "bump" && event.bumps === snapshot.bumps;
  return isKnown ? event.diagnosis : null;
}

/** What a line says: its rule, or the action of "otherwise". */
type LineContent = Rule | PlainAction;

/**
 * @param content what the line says now
 * @returns null unless the robot touches a wall at the displayed tick and this line caused that
 *   bump as it is now
 */
export function shownBump(
  line: LineRef,
  content: LineContent,
  { snapshot, event }: Pick<RunState, "snapshot"> & { event: BumpEvent | null },
): ShownBump | null {
  const diagnosis = shownDiagnosis({ snapshot, event });
  if (event === null || diagnosis === null || causeLine(diagnosis) !== line) return null;
  const { cause, program } = event;
  if (program === null || !says(program, line, content)) return null;
  // Another line may have driven into the wall.
  const isOwn = cause !== null && event.line === line;
  if (!isOwn || cause.needed === null) return { driven: null, needed: null };
  return { driven: Math.round(cause.driven), needed: cause.needed };
}

/** Whether this is what a line of the program says. */
function says({ rules, default: action }: ProgramDocument, line: LineRef, content: LineContent) {
  if (typeof content === "string" || line === "default") return content === action;
  const rule = rules[line];
  return rule !== undefined && isSameRule(rule, content);
}
