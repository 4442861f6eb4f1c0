/**
 * The time of the Redis server. Relays that share a Redis compare deadlines that other relays have
 * stored. The clocks of their machines may differ by a minute.
 *
 * This clock is the relay's own clock plus an offset that is measured periodically. It never goes
 * back, so that no deadline is extended. If Redis is ahead, the clock jumps forward. If Redis is
 * slightly behind, the clock slows down. If the clock of Redis was set back, the offset stays
 * unchanged.
 */
import type { Logger } from "pino";
import { CLOCK_TOLERANCE_MS } from "../../commands/robot-step.ts";
import type { Clock } from "../../platform/time/clock.ts";

const LOOK_MS = 5_000;
/** Maximum decrease of the offset per measurement: less than a thousandth of the interval. */
const SLOWER_MS = 4;

export interface RedisClockOptions {
  clock: Clock;
  log: Logger;
  /** time of the Redis server in ms since 1970 */
  ask: () => Promise<number>;
}

export class RedisClock implements Clock {
  readonly #options: RedisClockOptions;
  #offset: number | null = null;
  #newest = -Infinity;
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
    clock.#reload();
    return clock;
  }

  now(): number {
    const now = Math.round(this.#options.clock.now() + (this.#offset ?? 0));
    this.#newest = Math.max(this.#newest, now);
    return this.#newest;
  }

  after(ms: number, call: () => void): () => void {
    return this.#options.clock.after(ms, call);
  }

  close(): void {
    this.#isClosed = true;
    this.#cancelTimer();
  }

  #reload(): void {
    if (this.#isClosed) return;
    this.#cancelTimer = this.#options.clock.after(LOOK_MS, () => {
      // The previous offset is accurate enough if Redis does not respond.
      void this.#look()
        .catch(() => undefined)
        .finally(() => this.#reload());
    });
  }

  async #look(): Promise<void> {
    const { clock, log, ask } = this.#options;
    const asked = clock.now();
    const there = await ask();
    const answered = clock.now();
    // Redis read its clock between the request and the response.
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
