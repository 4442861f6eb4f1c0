/**
 * Cancels the commands that were sent before the page took the robot: they are for an outdated
 * state, so they never run, even if they arrive later.
 */
import { pageReasons, type CancelReason } from "../protocol/cancel-reason.ts";

export class CommandSweep {
  #swept: { upTo: number; reason: CancelReason } | null = null;
  /**
   * seq of the first command that the page ended, until the relay confirms its ending; commands
   * reported before that were sent before, too
   */
  #unconfirmed: number | null = null;

  /** The robot has ended a command. */
  ended(seq: number, reason: CancelReason | null): void {
    if (reason !== null && pageReasons.has(reason)) this.#unconfirmed ??= seq;
  }

  /**
   * All delivered commands have ended.
   * @param newestSeq highest seq that the page knows
   */
  begin(reason: CancelReason, newestSeq: number): void {
    if (pageReasons.has(reason)) this.#swept = { upTo: newestSeq, reason };
  }

  /** A command is queued at the relay. */
  queued(seq: number): void {
    if (this.#unconfirmed === null || this.#swept === null) return;
    this.#swept.upTo = Math.max(this.#swept.upTo, seq);
  }

  /** The relay has confirmed that this command ended. */
  confirmed(seq: number): void {
    if (seq === this.#unconfirmed) this.#unconfirmed = null;
  }

  /** Why a delivered command must not run; null if it may. */
  reasonFor(seq: number): CancelReason | null {
    return this.#swept !== null && seq <= this.#swept.upTo ? this.#swept.reason : null;
  }

  /** Another robot, whose commands have other numbers. */
  reset(): void {
    this.#swept = null;
    this.#unconfirmed = null;
  }
}
