/**
 * An earlier displayed tick of the run, which can be played towards the newest. Only the newest of
 * several requested ticks is computed.
 */
import type { Playback, Recording, Run } from "@corridor/recording";

export class PastPlayback {
  readonly #recording: Recording;
  readonly #playback: Playback;
  #tick: number;
  /** whether the recording is being played */
  isPlaying = false;

  constructor(recording: Recording) {
    this.#recording = recording;
    this.#playback = recording.playback();
    this.#tick = recording.run.tick;
  }

  get tick(): number {
    return this.#tick;
  }

  /** The run at the displayed tick; read-only. */
  get run(): Run {
    this.#playback.seek(this.#tick);
    return this.#playback.run;
  }

  /** Displays the state at the end of a tick, as far as the recording goes. */
  goTo(tick: number): void {
    this.#tick = Math.min(Math.max(0, Math.floor(tick)), this.#recording.run.tick);
  }

  /** Plays this many ticks, immediately, so that their time is part of the playback. */
  playOn(ticks: number): void {
    this.goTo(this.#tick + ticks);
    this.#playback.seek(this.#tick);
  }

  /** Displays the previous decision. */
  goToDecisionBefore(): void {
    this.goTo(this.#recording.decisionBefore(this.#tick, this.#playback));
  }

  /** Displays the next decision; without one, the end of the recording. */
  goToDecisionAfter(): void {
    const decision = this.#recording.decisionAfter(this.#tick, this.#playback);
    this.goTo(decision ?? this.#recording.run.tick);
  }

  /** Whether the displayed tick is the recording's last. */
  get isAtEnd(): boolean {
    return this.#tick >= this.#recording.run.tick;
  }
}
