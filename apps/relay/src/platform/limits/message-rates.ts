/** Limits how often one client sends each kind of message. */
import { Refusal, retryAfter } from "../errors/problems.ts";
import type { Clock } from "../time/clock.ts";
import { TokenBucket } from "./token-bucket.ts";

export class MessageRates<K extends string> {
  readonly #rates: Readonly<Record<K, { perSecond: number; burst: number }>>;
  readonly #clock: Clock;
  readonly #buckets = new Map<K, TokenBucket>();

  constructor(rates: Readonly<Record<K, { perSecond: number; burst: number }>>, clock: Clock) {
    this.#rates = rates;
    this.#clock = clock;
  }

  /** Counts a message. @throws Refusal too-fast */
  count(kind: K): void {
    const now = this.#clock.now();
    const bucket = this.#buckets.get(kind) ?? new TokenBucket(this.#rates[kind], now);
    this.#buckets.set(kind, bucket);
    const waitMs = bucket.take(now);
    if (waitMs === 0) return;
    const { perSecond } = this.#rates[kind];
    const detail = `Too many messages of the type ${kind}: at most ${perSecond} a second. Wait, then send it again.`;
    throw new Refusal("too-fast", detail, { headers: retryAfter(waitMs) });
  }
}
