/**
 * Listens to the run store and notes what is worth saying: which line drives from now on, each turn, a
 * pause, going back in time and coming back. Bumps and the goal come at any speed; everything else is
 * left out where the robot is faster than words. Pure.
 */
import type { ProgramDocument } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import { decidingLine } from "../program/line-state.ts";
import type { RunState } from "../../stores/run-store.ts";
import type { RunEvent } from "../../worker/worker-messages.ts";

/** From this speed on lines change faster than they can be said. */
const FASTEST_TOLD = 4;
const STEADY: ReadonlySet<string> = new Set(["forward", "reverse", "stop"]);
/** A step of one tick is shorter than any run that a student pauses. */
const SHORT_TICKS = 4;
/** Rounding leaves crumbs of a distance. */
const CRUMB = 1e-6;

export type RunTalk =
  | { kind: "event"; event: RunEvent }
  /** a line drives from now on; `isTurn`: it does something once, that may come again */
  | { kind: "decision"; line: LineRef; isTurn: boolean }
  | { kind: "paused" | "at-start" | "now" | "playing" }
  /** an earlier moment is shown; `isFirst` where now was shown before */
  | { kind: "past"; isFirst: boolean }
  /** it goes too fast from here on: what waits to be said is out of date */
  | { kind: "too-fast" };

/** What is remembered of the state before. */
type Heard = Pick<RunState, "snapshot" | "progress" | "view" | "nowTick" | "event">;

export class RunEar {
  #before: Heard;
  /** the line that was told has not yet begun the turn that it was told with */
  #isTurnTold = false;
  #wasTooFast = false;
  /** tick at which the robot was let go */
  #runsFrom = 0;

  /** @param state what is on the screen already: it is no news */
  constructor(state: Heard) {
    this.#before = state;
  }

  /** @returns what the new state has to say; null for nothing */
  hear(state: RunState, program: ProgramDocument): RunTalk | null {
    const before = this.#before;
    this.#before = state;
    const { snapshot, event, view, nowTick } = state;
    if (snapshot === null) return null;
    if (event !== null && event !== before.event) return { kind: "event", event };
    if (view !== before.view) return viewTalk(view);
    const tick = before.snapshot?.tick ?? 0;
    if (view === "past") return snapshot.tick === tick ? null : { kind: "past", isFirst: false };
    if (nowTick === 0 && before.nowTick > 0) return { kind: "at-start" };
    if (snapshot.state !== "running") return this.#hearStill(before, state, tick);
    return this.#hearRunning(before, state, program);
  }

  /** Nobody drives: a pause, or one decision by Step. */
  #hearStill(before: Heard, { snapshot }: RunState, tick: number): RunTalk | null {
    this.#wasTooFast = false;
    if (snapshot === null || snapshot.bumping || snapshot.goalReached) return null;
    if (before.snapshot?.state === "running") {
      const line = decidingLine(snapshot);
      // Step pauses where another line decides: that decision is what there is to say.
      if (line !== null && line !== decidingLine(before.snapshot))
        return { kind: "decision", line, isTurn: true };
      const isShort = snapshot.tick - this.#runsFrom < SHORT_TICKS;
      return snapshot.driver === "program" && !isShort ? { kind: "paused" } : null;
    }
    // What the page opens with is no news.
    if (before.snapshot === null) return null;
    const line = decidingLine(snapshot);
    // Each press of Step is answered, also when the same line decides again.
    return line === null || snapshot.tick === tick
      ? null
      : { kind: "decision", line, isTurn: true };
  }

  #hearRunning(before: Heard, state: RunState, program: ProgramDocument): RunTalk | null {
    const { snapshot, speed } = state;
    if (speed === "max" || speed >= FASTEST_TOLD) {
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
      this.#isTurnTold = isTurn && state.progress === null;
      return { kind: "decision", line, isTurn };
    }
    if (!hasBegun) return null;
    const wasTold = this.#isTurnTold;
    this.#isTurnTold = false;
    return wasTold ? null : { kind: "decision", line, isTurn };
  }
}

function viewTalk(view: RunState["view"]): RunTalk {
  return view === "past" ? { kind: "past", isFirst: true } : { kind: view };
}

/** Whether a manoeuvre has begun since the state before. */
function begins(before: Heard, { progress }: Heard): boolean {
  if (progress === null) return false;
  const last = before.progress;
  if (last === null || progress.part < last.part) return true;
  return progress.part === last.part && progress.left > last.left + CRUMB;
}

function actionOf({ rules, default: otherwise }: ProgramDocument, line: LineRef): string {
  return line === "default" ? otherwise : (rules[line]?.do ?? otherwise);
}
