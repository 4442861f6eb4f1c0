/** How fast each driver key may send: a bucket for commands, and one for stops, which never wait behind them. */
import { Refusal, retryAfter } from "../problems.ts";
import { limits } from "./limits.ts";
import { TokenBucket } from "./token-bucket.ts";

export class DriverAllowance {
  readonly #buckets = new Map<string, { commands: TokenBucket; stops: TokenBucket }>();

  /**
   * Takes one command's worth.
   * @param driver hash of the key
   * @param now when it came
   * @returns the refusal when the key sends too fast
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
