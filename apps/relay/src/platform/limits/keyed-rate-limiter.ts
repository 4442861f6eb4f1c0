/**
 * A token bucket for each key, such as the address of a client. A bucket that is full again is
 * deleted within a minute, because a new one would be equal.
 */
import type { Clock } from "../time/clock.ts";
import { TokenBucket } from "./token-bucket.ts";

const CLEANUP_MS = 60_000;

export class KeyedRateLimiter {
  readonly #clock: Clock;
  readonly #rate: { perSecond: number; burst: number };
  readonly #buckets = new Map<string, TokenBucket>();

  constructor(clock: Clock, rate: { perSecond: number; burst: number }) {
    this.#clock = clock;
    this.#rate = rate;
  }

  /** Number of keys that are held in memory. */
  get size(): number {
    return this.#buckets.size;
  }

  /** Takes one token of a key. @returns 0, or the ms until one is available */
  take(key: string): number {
    const now = this.#clock.now();
    // Without keys no timer runs, so the limiter needs no end.
    if (this.#buckets.size === 0) this.#clock.after(CLEANUP_MS, () => this.#deleteFull());
    const bucket = this.#buckets.get(key) ?? new TokenBucket(this.#rate, now);
    this.#buckets.set(key, bucket);
    return bucket.take(now);
  }

  #deleteFull(): void {
    const now = this.#clock.now();
    for (const [key, bucket] of this.#buckets) if (bucket.isFull(now)) this.#buckets.delete(key);
    if (this.#buckets.size > 0) this.#clock.after(CLEANUP_MS, () => this.#deleteFull());
  }
}
