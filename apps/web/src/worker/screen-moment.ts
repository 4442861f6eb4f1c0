/**
 * The moment of the run that is on the screen: the newest, or an earlier one that was gone back to; and
 * the frames that show it.
 */
import type { MazeDocument } from "@corridor/maze";
import type { Snapshot } from "@corridor/protocol";
import type { Run } from "@corridor/recording";
import type { LiveRun } from "./live-run.ts";
import { isDecidedAnew, shownLine } from "./shown-line.ts";
import { ShownPast } from "./shown-past.ts";
import { TrailFeed } from "./trail-feed.ts";
import type { Frame, RunView } from "./worker-messages.ts";

export class ScreenMoment {
  readonly #live: LiveRun;
  readonly #trail = new TrailFeed();
  /** null while the newest moment is shown */
  #past: ShownPast | null = null;
  #seq = 0;

  constructor(live: LiveRun) {
    this.#live = live;
  }

  get isPast(): boolean {
    return this.#past !== null;
  }

  /** Whether one moment after the other is shown, towards the newest. */
  get isPlaying(): boolean {
    return this.#past?.isPlaying === true;
  }

  /** Whether playing or stepping on has come to the newest moment. */
  get isAtEnd(): boolean {
    return this.#past?.isAtEnd === true;
  }

  get tick(): number {
    return this.#past?.tick ?? this.#live.run.tick;
  }

  /** The maze of the shown moment where it is not the newest one. */
  get maze(): MazeDocument | null {
    const { maze } = this.#run;
    return maze === this.#live.maze ? null : maze;
  }

  /** Goes to the moment at the end of a tick. */
  seek(tick: number): void {
    this.#lookBack().goTo(tick);
  }

  /** Goes to the decision before or after the shown moment. */
  seekStep(by: 1 | -1): void {
    const past = this.#lookBack();
    if (by === 1) past.goToDecisionAfter();
    else past.goToDecisionBefore();
  }

  /** Begins to play on from the shown moment. */
  play(): void {
    if (this.#past !== null) this.#past.isPlaying = true;
  }

  /** Plays so many ticks on. */
  playOn(ticks: number): void {
    this.#past?.playOn(ticks);
  }

  pause(): void {
    if (this.#past !== null) this.#past.isPlaying = false;
  }

  /** Shows the newest moment again. */
  leavePast(): void {
    this.#past = null;
  }

  /** Another run is the live one now. */
  begin(): void {
    this.#past = null;
    this.#trail.begin();
  }

  /** @param isRunning whether the live run goes on */
  frame(isRunning: boolean): Frame {
    const { recording, program, driver, revision } = this.#live;
    const run = this.#run;
    return {
      snapshot: this.#snapshotOf(run, this.#past === null ? isRunning : this.isPlaying),
      progress: isDecidedAnew(run, program) ? null : run.progress,
      view: this.#view,
      nowTick: recording.run.tick,
      waited: recording.timeline.commands.waitedUpTo(run.tick),
      nowDriver: driver,
      revision,
      ...this.#trail.take(recording, run.tick),
    };
  }

  /** The newest moment, for scripts; every snapshot has its own seq. @param isRunning whether it goes on */
  newest(isRunning: boolean): Snapshot {
    return this.#snapshotOf(this.#live.run, isRunning);
  }

  get #run(): Run {
    return (this.#past ?? this.#live).run;
  }

  get #view(): RunView {
    if (this.#past === null) return "now";
    return this.#past.isPlaying ? "playing" : "past";
  }

  #lookBack(): ShownPast {
    this.#past ??= new ShownPast(this.#live.recording);
    this.#past.isPlaying = false;
    return this.#past;
  }

  #snapshotOf(run: Run, isRunning: boolean): Snapshot {
    const { tick, ...report } = run.report();
    // In this order a relay passes it on without reading it further.
    return {
      seq: ++this.#seq,
      tick,
      state: isRunning ? "running" : "paused",
      driver: run.driver,
      ...report,
      line: shownLine(run, this.#live.program),
      command: run.command,
    };
  }
}
