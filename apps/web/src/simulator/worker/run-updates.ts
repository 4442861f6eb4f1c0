/**
 * What the page receives from the run: frames and events since the last call, the timeline, the
 * diagnosis of a failure, and the judgement of a challenge.
 */
import type { Judgement } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";
import type { TimelineDelta } from "@corridor/recording";
import type { Frame, GhostPose } from "../../stage/drawing/frame.ts";
import type { RunEvent } from "../protocol/worker-messages.ts";
import type { DiagnosedRun } from "./diagnose-run.ts";
import type { DisplayedTick } from "./displayed-tick.ts";
import type { LiveRun } from "./live-run.ts";
import type { Diagnostics } from "./run-diagnosis.ts";
import type { RunJudge } from "./run-judge.ts";
import type { RunObserver } from "./run-observer.ts";

/** Poses of a race's ghosts at the end of a tick. */
interface Ghosts {
  posesAt(tick: number): readonly GhostPose[];
}

/** Changes to draw and to report. */
export interface RunUpdate {
  frame: Frame;
  events: RunEvent[];
  /** the tick after which reported events were truncated; null without a truncation */
  truncatedAfter: number | null;
}

export class RunUpdates {
  readonly #live: LiveRun;
  readonly #screen: DisplayedTick;
  readonly #observer: RunObserver;
  /** null without a race */
  #ghosts: Ghosts | null = null;
  #isDirty = true;

  constructor(live: LiveRun, screen: DisplayedTick, observer: RunObserver) {
    this.#live = live;
    this.#screen = screen;
    this.#observer = observer;
  }

  /** The run or its display has changed, so that the next `take` returns an update. */
  changed(): void {
    this.#isDirty = true;
  }

  /** The changes since the last call; null without any. */
  take(): RunUpdate | null {
    if (!this.#isDirty) return null;
    this.#isDirty = false;
    const frame = this.#screen.frame();
    if (this.#ghosts !== null) frame.ghosts = this.#ghosts.posesAt(frame.snapshot.tick);
    const truncatedAfter = this.#observer.takeTruncatedAfter();
    return { frame, events: this.#observer.takeEvents(), truncatedAfter };
  }

  /** Changes of the timeline since the last call; null without any. */
  takeTimeline(): TimelineDelta | null {
    return this.#live.recording.timeline.takeDelta();
  }

  /** The maze at the displayed tick if it is not the newest one; otherwise null. */
  get pastMaze(): MazeDocument | null {
    return this.#screen.maze;
  }

  /**
   * Frames contain the ghosts of a race from now on, each at the displayed tick. Called again when
   * they change.
   */
  raceWith(ghosts: Ghosts): void {
    this.#ghosts = ghosts;
    this.changed();
  }

  /** The diagnostics module has loaded. */
  useDiagnostics(diagnostics: Diagnostics): void {
    this.#observer.useDiagnostics(diagnostics, this.#live.recording);
    this.changed();
  }

  /** The diagnostics module is loading, or could not be loaded. */
  awaitDiagnostics(isLoading: boolean): void {
    this.#observer.awaitDiagnostics(isLoading, this.#live.run);
    this.changed();
  }

  /**
   * Why the program's robot does not reach the goal; null without a new diagnosis since the last
   * call.
   */
  takeDiagnosed(): DiagnosedRun | null {
    return this.#observer.takeDiagnosed();
  }

  /** Judges the run by a challenge from its first tick on; null: by none. */
  judgeBy(judge: RunJudge | null): void {
    this.#observer.judgeBy(judge, this.#live.recording);
    this.changed();
  }

  /** The judgement of the challenge if it changed since the last call; otherwise null. */
  takeJudgement(): Judgement | null {
    const isResting = !this.#screen.isPast && !this.#live.isRunning;
    return this.#observer.takeJudgement(this.#live.run, isResting);
  }
}
