/**
 * How often somebody may be wrong: so many times in a time, then nobody looks at their tries for a while, which
 * doubles with every further wrong one. A try counts as wrong until it turns out right, so that many at once
 * find out no more than one after the other.
 */
export interface TryLimitRule {
  wrong: { count: number; inMs: number };
  delay: { firstMs: number; mostMs: number };
}

export class TryLimit {
  readonly #rule: TryLimitRule;
  /** when the wrong ones of late came, and those that are not known yet */
  #tries: number[] = [];
  #delayMs = 0;
  #blockedUntil = -Infinity;

  constructor(rule: TryLimitRule) {
    this.#rule = rule;
  }

  /** @returns 0, or the ms for which no try is looked at */
  waitMs(now: number): number {
    return Math.max(0, this.#blockedUntil - now);
  }

  /** Counts a try. @returns to be called when it was right, or nothing was found out by it */
  begin(now: number): () => void {
    this.#forget(now);
    this.#tries.push(now);
    const { wrong, delay } = this.#rule;
    const isOver = this.#tries.length >= wrong.count;
    const before = this.#delayMs;
    if (isOver) {
      this.#delayMs = Math.min(delay.mostMs, Math.max(delay.firstMs, this.#delayMs * 2));
      this.#blockedUntil = now + this.#delayMs;
    }
    return () => {
      const at = this.#tries.indexOf(now);
      if (at >= 0) this.#tries.splice(at, 1);
      if (!isOver) return;
      this.#delayMs = before;
      this.#blockedUntil = now;
    };
  }

  /** Whether a new one would be the same. */
  isFresh(now: number): boolean {
    this.#forget(now);
    return this.#tries.length === 0 && this.waitMs(now) === 0;
  }

  #forget(now: number): void {
    const oldest = now - this.#rule.wrong.inMs;
    this.#tries = this.#tries.filter((at) => at > oldest);
    if (this.#tries.length === 0 && this.waitMs(now) === 0) this.#delayMs = 0;
  }
}
