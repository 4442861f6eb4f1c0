/** Rate limiter by driver key. Stops have a separate bucket, so they never wait behind commands. */
import { Refusal, retryAfter } from "../../platform/errors/problems.ts";
import { limits } from "../../platform/limits/limits.ts";
import { TokenBucket } from "../../platform/limits/token-bucket.ts";

export class DriverRateLimiter {
  readonly #buckets = new Map<string, { commands: TokenBucket; stops: TokenBucket }>();

  /**
   * Takes one token.
   * @param driver hash of the key
   * @param now time of arrival, in ms
   * @returns the error response if the key exceeds its rate; otherwise null
   */
  take(driver: string, isStop: boolean, now: number): Refusal | null {
    let buckets = this.#buckets.get(driver);
    if (buckets === undefined) {
      buckets = {
        commands: new TokenBucket(limits.commandRate, now),
        stops: new TokenBucket(limits.stopRate, now),
      };
      this.#buckets.set(driver, buckets);
    }
    const waitMs = (isStop ? buckets.stops : buckets.commands).take(now);
    if (waitMs === 0) return null;
    const { perSecond, burst } = isStop ? limits.stopRate : limits.commandRate;
    return new Refusal(
      "too-fast",
      `Too many ${isStop ? "stops" : "commands"}: a key can send ${perSecond} a second, with bursts of ${burst}. Wait a second, then send this command again.`,
      { headers: retryAfter(waitMs) },
    );
  }
}
