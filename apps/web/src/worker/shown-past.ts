/**
 * An earlier moment of the run that is shown, or played on towards now. Moments that were asked for and
 * not shown yet cost nothing: only the newest is gone to.
 */
import type { Playback, Recording, Run } from "@corridor/recording";

export class ShownPast {
  readonly #recording: Recording;
  readonly #playback: Playback;
  #tick: number;
  /** whether one moment after the other is shown */
  isPlaying = false;

  constructor(recording: Recording) {
    this.#recording = recording;
    this.#playback = recording.playback();
    this.#tick = recording.run.tick;
  }

  get tick(): number {
    return this.#tick;
  }

  /** The run at the shown moment; not to be changed. */
  get run(): Run {
    this.#playback.seek(this.#tick);
    return this.#playback.run;
  }

  /** Shows the moment at the end of a tick, as far as the recording goes. */
  goTo(tick: number): void {
    this.#tick = Math.min(Math.max(0, Math.floor(tick)), this.#recording.run.tick);
  }

  /** Plays so many ticks on; done at once, so that its time is part of the playing. */
  playOn(ticks: number): void {
    this.goTo(this.#tick + ticks);
    this.#playback.seek(this.#tick);
  }

  /** Shows the decision before the shown moment. */
  goToDecisionBefore(): void {
    this.goTo(this.#recording.decisionBefore(this.#tick, this.#playback));
  }

  /** Shows the decision after the shown moment; without one, the recording's end. */
  goToDecisionAfter(): void {
    const decision = this.#recording.decisionAfter(this.#tick, this.#playback);
    this.goTo(decision ?? this.#recording.run.tick);
  }

  /** Whether the shown moment is the recording's last. */
  get isAtEnd(): boolean {
    return this.#tick >= this.#recording.run.tick;
  }
}
