/**
 * Time as Redis has it. Relays that share one compare deadlines that others of them have stored; the
 * clocks of their machines may be a minute apart, that of Redis is one.
 *
 * It is the relay's own clock with an offset that is measured again and again. Ahead it follows at once;
 * it never goes back, so that nothing gets more time: a little too far ahead it goes more slowly, and a
 * Redis whose clock was set back is not followed.
 */
import type { Logger } from "pino";
import { CLOCK_TOLERANCE_MS } from "../session-store.ts";
import type { Clock } from "../../clock.ts";

const LOOK_MS = 5_000;
/** taken off at one look: less than a thousandth of the time that has passed since the one before */
const SLOWER_MS = 4;

export interface RedisClockOptions {
  clock: Clock;
  log: Logger;
  /** ms since 1970, as Redis believes */
  ask: () => Promise<number>;
}

export class RedisClock implements Clock {
  readonly #options: RedisClockOptions;
  #offset: number | null = null;
  #told = -Infinity;
  #isSetBack = false;
  #cancelTimer: () => void = () => undefined;
  #isClosed = false;

  private constructor(options: RedisClockOptions) {
    this.#options = options;
  }

  /** @throws what `ask` throws */
  static async open(options: RedisClockOptions): Promise<RedisClock> {
    const clock = new RedisClock(options);
    await clock.#look();
    clock.#lookAgain();
    return clock;
  }

  now(): number {
    const now = Math.round(this.#options.clock.now() + (this.#offset ?? 0));
    this.#told = Math.max(this.#told, now);
    return this.#told;
  }

  after(ms: number, call: () => void): () => void {
    return this.#options.clock.after(ms, call);
  }

  close(): void {
    this.#isClosed = true;
    this.#cancelTimer();
  }

  #lookAgain(): void {
    if (this.#isClosed) return;
    this.#cancelTimer = this.#options.clock.after(LOOK_MS, () => {
      // Where Redis does not answer, the offset of before is good enough.
      void this.#look()
        .catch(() => undefined)
        .finally(() => this.#lookAgain());
    });
  }

  async #look(): Promise<void> {
    const { clock, log, ask } = this.#options;
    const asked = clock.now();
    const there = await ask();
    const answered = clock.now();
    // It was asked for its time at some moment in between.
    const [least, most] = [there - answered, there - asked];
    const before = this.#offset;
    if (before === null) this.#offset = (least + most) / 2;
    else if (before < least) this.#offset = least;
    const isSetBack = before !== null && before > most + CLOCK_TOLERANCE_MS;
    if (isSetBack && !this.#isSetBack) log.warn("the clock of Redis was set back");
    this.#isSetBack = isSetBack;
    if (before !== null && before > most && !isSetBack)
      this.#offset = Math.max(most, before - SLOWER_MS);
  }
}
