/**
 * Estimates the transit time of one sender's messages. It never compares the clocks of sender and
 * relay. It only measures how much later than the fastest message another one arrived.
 */

/**
 * Assumed maximum drift between the sender's clock and the relay's, as a share of the elapsed time.
 * Crystals of computers differ by 0.0001 at most. So drift alone never makes a message of a long
 * session look late. The error for the fastest message is 18 ms a minute at most.
 */
const LARGEST_DRIFT = 0.0002;

export class TransitEstimate {
  /**
   * smallest difference between the relay's and the sender's clock; Infinity before the first
   * message
   */
  #offset = Infinity;

  /**
   * Records a message.
   * @param sentAt ms of the sender's monotonic clock; only differences count
   * @param arrivedAt ms of the relay's clock
   * @returns ms of transit beyond the fastest message so far; 0 for the first, never negative
   */
  came(sentAt: number, arrivedAt: number): number {
    // Counts the relay's time slightly slow, so that drift only lowers the offset.
    const offset = arrivedAt * (1 - LARGEST_DRIFT) - sentAt;
    this.#offset = Math.min(this.#offset, offset);
    return Math.round(offset - this.#offset);
  }
}
