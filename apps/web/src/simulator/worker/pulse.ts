/**
 * The regular turns of the worker: often while something moves, seldom while nothing does. 125 turns
 * per second cost an idle page 1 to 3 % of a core, and a tablet its battery.
 */

/** Half of a 60 Hz frame, so that no frame waits for a whole interval. */
export const FAST_MS = 8;
/** Short enough that nobody notices a change that waits for a turn. */
export const SLOW_MS = 50;
/** Turns without work until the interval becomes slow: a second. */
const QUIET_TURNS = 125;

export class Pulse {
  readonly #turn: () => boolean;
  #timer: ReturnType<typeof setInterval>;
  #intervalMs = FAST_MS;
  #quietTurns = 0;

  /** @param turn returns whether something moves */
  constructor(turn: () => boolean) {
    this.#turn = turn;
    this.#timer = setInterval(() => this.#beat(), FAST_MS);
  }

  /** Something may move from now on. */
  wake(): void {
    this.#quietTurns = 0;
    this.#every(FAST_MS);
  }

  #beat(): void {
    if (this.#turn()) return this.wake();
    this.#quietTurns++;
    if (this.#quietTurns >= QUIET_TURNS) this.#every(SLOW_MS);
  }

  #every(milliseconds: number): void {
    if (this.#intervalMs === milliseconds) return;
    this.#intervalMs = milliseconds;
    clearInterval(this.#timer);
    this.#timer = setInterval(() => this.#beat(), milliseconds);
  }
}
