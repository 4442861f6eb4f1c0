/** The displayed tick of the run, the newest or an earlier one, and the frames that show it. */
import type { MazeDocument } from "@corridor/maze";
import type { Snapshot } from "@corridor/protocol";
import type { Run } from "@corridor/recording";
import type { LiveRun } from "./live-run.ts";
import { displayedLine, isDecidedAnew, lastLine } from "./displayed-line.ts";
import { PastPlayback } from "./past-playback.ts";
import { TrailFeed } from "./trail-feed.ts";
import type { Frame, RunView } from "../../stage/drawing/frame.ts";

export class DisplayedTick {
  readonly #live: LiveRun;
  readonly #trail = new TrailFeed();
  /** null while the newest tick is displayed */
  #past: PastPlayback | null = null;
  #seq = 0;

  constructor(live: LiveRun) {
    this.#live = live;
  }

  get isPast(): boolean {
    return this.#past !== null;
  }

  /** Whether the recording is played towards the newest tick. */
  get isPlaying(): boolean {
    return this.#past?.isPlaying === true;
  }

  /** Whether playing or stepping has reached the newest tick. */
  get isAtEnd(): boolean {
    return this.#past?.isAtEnd === true;
  }

  get tick(): number {
    return this.#past?.tick ?? this.#live.run.tick;
  }

  /** The maze at the displayed tick if it is not the newest one; otherwise null. */
  get maze(): MazeDocument | null {
    const { maze } = this.#run;
    return maze === this.#live.maze ? null : maze;
  }

  /** Displays the state at the end of a tick. */
  seek(tick: number): void {
    this.#lookBack().goTo(tick);
  }

  /** Displays the previous or next decision. */
  seekStep(by: 1 | -1): void {
    const past = this.#lookBack();
    if (by === 1) past.goToDecisionAfter();
    else past.goToDecisionBefore();
  }

  /** Starts to play the recording from the displayed tick. */
  play(): void {
    if (this.#past !== null) this.#past.isPlaying = true;
  }

  /** Plays this many ticks. */
  playOn(ticks: number): void {
    this.#past?.playOn(ticks);
  }

  pause(): void {
    if (this.#past !== null) this.#past.isPlaying = false;
  }

  /** Displays the newest tick again. */
  leavePast(): void {
    this.#past = null;
  }

  /** Another run is the live one now. */
  begin(): void {
    this.#past = null;
    this.#trail.begin();
  }

  frame(): Frame {
    const { recording, program, driver, revision, startedAt, isRunning } = this.#live;
    const run = this.#run;
    const snapshot = this.#snapshotOf(run, this.#past === null ? isRunning : this.isPlaying);
    const endLine = this.#past === null && !isRunning ? lastLine(run) : null;
    const hasEnded = endLine !== null;
    if (hasEnded) snapshot.line = endLine;
    // A manoeuvre that was chosen at the end of the run has not begun.
    const isChosenAnew = isDecidedAnew(run, program) || (hasEnded && run.decidedAt === run.tick);
    return {
      snapshot,
      hasEnded,
      progress: isChosenAnew ? null : run.progress,
      view: this.#view,
      nowTick: recording.run.tick,
      waited: recording.timeline.commands.waitedUpTo(run.tick),
      nowDriver: driver,
      revision,
      startedAt,
      ...this.#trail.take(recording, run.tick),
    };
  }

  /** The newest state, for scripts; every snapshot has its own seq. */
  newest(): Snapshot {
    return this.#snapshotOf(this.#live.run, this.#live.isRunning);
  }

  get #run(): Run {
    return (this.#past ?? this.#live).run;
  }

  get #view(): RunView {
    if (this.#past === null) return "now";
    return this.#past.isPlaying ? "playing" : "past";
  }

  #lookBack(): PastPlayback {
    this.#past ??= new PastPlayback(this.#live.recording);
    this.#past.isPlaying = false;
    return this.#past;
  }

  #snapshotOf(run: Run, isRunning: boolean): Snapshot {
    const { tick, ...report } = run.report();
    // A relay forwards a snapshot with this field order without parsing it further.
    return {
      seq: ++this.#seq,
      tick,
      state: isRunning ? "running" : "paused",
      driver: run.driver,
      ...report,
      line: displayedLine(run, this.#live.program),
      command: run.command,
    };
  }
}
