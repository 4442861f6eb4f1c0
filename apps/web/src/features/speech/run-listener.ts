/**
 * Listens to the run store and returns what to announce: the new deciding line, each turn, a pause,
 * and moves in time. Bumps and the goal count at any speed. Everything else is dropped where the
 * robot is faster than speech. Pure.
 */
import type { ProgramDocument } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import { decidingLine } from "../../model/run/line-state.ts";
import type { RunState } from "../../model/run/run-store.ts";
import type { RunEvent } from "../../simulator/protocol/worker-messages.ts";

/** From this speed on, lines change faster than speech. */
const TOO_FAST = 4;
const STEADY: ReadonlySet<string> = new Set(["forward", "reverse", "stop"]);
/** A run with fewer ticks is too short for a pause announcement, such as a step of one tick. */
const SHORT_TICKS = 4;
/** Allows for rounding errors in a distance. */
const EPSILON = 1e-6;

export type RunAnnouncement =
  | { kind: "event"; event: RunEvent }
  /** a line starts to drive; `isTurn`: its action ends by itself and may repeat */
  | { kind: "decision"; line: LineRef; isTurn: boolean }
  | { kind: "paused" | "at-start" | "now" | "playing" }
  /** an earlier tick is displayed; `isFirst` if the present was displayed before */
  | { kind: "past"; isFirst: boolean }
  /** the run is too fast from here on, so pending announcements are out of date */
  | { kind: "too-fast" };

/** The fields of the last state. */
type LastState = Pick<RunState, "snapshot" | "progress" | "view" | "nowTick" | "event">;

export class RunListener {
  #before: LastState;
  /** whether the last announced line has not started its announced turn yet */
  #isTurnAnnounced = false;
  #wasTooFast = false;
  /** whether the robot has left its start; at the highest speed an event may precede all frames */
  #hasRun: boolean;
  /** tick at which the robot started */
  #runsFrom = 0;

  /** @param state the initial state, which is not announced */
  constructor(state: LastState) {
    this.#before = state;
    this.#hasRun = hasRun(state);
  }

  /** @returns the announcement for the new state; null if there is none */
  update(state: RunState, program: ProgramDocument): RunAnnouncement | null {
    const before = this.#before;
    this.#before = state;
    const { snapshot, event, view, nowTick } = state;
    if (snapshot === null) return null;
    this.#hasRun ||= hasRun(state);
    if (event !== null && event !== before.event) return { kind: "event", event };
    if (view !== before.view) return viewAnnouncement(view);
    const tick = before.snapshot?.tick ?? 0;
    if (view === "past") return snapshot.tick === tick ? null : { kind: "past", isFirst: false };
    if (this.#hasRun && nowTick === 0 && snapshot !== before.snapshot) {
      this.#hasRun = false;
      return { kind: "at-start" };
    }
    if (snapshot.state !== "running") return this.#atRest(before, state, tick);
    return this.#whileRunning(before, state, program);
  }

  /** The robot rests: a pause, or one decision by Step. */
  #atRest(before: LastState, { snapshot }: RunState, tick: number): RunAnnouncement | null {
    this.#wasTooFast = false;
    if (snapshot === null || snapshot.bumping || snapshot.goalReached) return null;
    if (before.snapshot?.state === "running") {
      const line = decidingLine(snapshot);
      // Step pauses where another line decides. The decision is the announcement.
      if (line !== null && line !== decidingLine(before.snapshot))
        return { kind: "decision", line, isTurn: true };
      const isShort = snapshot.tick - this.#runsFrom < SHORT_TICKS;
      return snapshot.driver === "program" && !isShort ? { kind: "paused" } : null;
    }
    // The initial state of the page is not announced.
    if (before.snapshot === null) return null;
    const line = decidingLine(snapshot);
    // Each press of Step gets an announcement, even if the same line decides again.
    return line === null || snapshot.tick === tick
      ? null
      : { kind: "decision", line, isTurn: true };
  }

  #whileRunning(
    before: LastState,
    state: RunState,
    program: ProgramDocument,
  ): RunAnnouncement | null {
    const { snapshot, speed } = state;
    if (speed === "max" || speed >= TOO_FAST) {
      if (this.#wasTooFast) return null;
      this.#wasTooFast = true;
      return { kind: "too-fast" };
    }
    if (before.snapshot?.state !== "running") this.#runsFrom = before.snapshot?.tick ?? 0;
    const line = decidingLine(snapshot);
    if (line === null) return null;
    const isTurn = !STEADY.has(actionOf(program, line));
    const isNewLine =
      this.#wasTooFast ||
      line !== decidingLine(before.snapshot) ||
      before.snapshot?.state !== "running";
    this.#wasTooFast = false;
    const hasBegun = begins(before, state);
    if (isNewLine) {
      this.#isTurnAnnounced = isTurn && state.progress === null;
      return { kind: "decision", line, isTurn };
    }
    if (!hasBegun) return null;
    const wasAnnounced = this.#isTurnAnnounced;
    this.#isTurnAnnounced = false;
    return wasAnnounced ? null : { kind: "decision", line, isTurn };
  }
}

function hasRun({ nowTick, event }: LastState): boolean {
  return nowTick > 0 || event !== null;
}

function viewAnnouncement(view: RunState["view"]): RunAnnouncement {
  return view === "past" ? { kind: "past", isFirst: true } : { kind: view };
}

/** Whether a manoeuvre has started since the last state. */
function begins(before: LastState, { progress }: LastState): boolean {
  if (progress === null) return false;
  const last = before.progress;
  if (last === null || progress.part < last.part) return true;
  return progress.part === last.part && progress.left > last.left + EPSILON;
}

function actionOf({ rules, default: otherwise }: ProgramDocument, line: LineRef): string {
  return line === "default" ? otherwise : (rules[line]?.do ?? otherwise);
}
