/**
 * How long the messages of one sender were on their way to this relay, as far as it can see that. The clocks of
 * sender and relay are never compared: only how much later than the quickest message another one came.
 */

/**
 * The sender's clock and the relay's may drift apart by so much of the time that passes; crystals of computers
 * differ by 0.0001 at most. So a message of a long session is never thought late for drift alone, and what is
 * thought of the quickest message is wrong by 18 ms a minute at most.
 */
const LARGEST_DRIFT = 0.0002;

export class TransitEstimate {
  /** the smallest difference between the relay's clock and the sender's; Infinity before the first message */
  #offset = Infinity;

  /**
   * A message came.
   * @param sentAt ms by the sender's monotonic clock when it was sent; only their difference counts
   * @param cameAt ms by the relay's clock when it came
   * @returns ms that it was on its way longer than the quickest one before; 0 for the first, never less
   */
  came(sentAt: number, cameAt: number): number {
    // The relay's time is counted a little slow, so that drift makes the offset fall and never rise.
    const offset = cameAt * (1 - LARGEST_DRIFT) - sentAt;
    this.#offset = Math.min(this.#offset, offset);
    return Math.round(offset - this.#offset);
  }
}
