/** Keeps codes from being guessed: limits for one address and, where asked for, for everybody; in memory only. */
import { Refusal, retryAfter } from "../problems.ts";
import { limits } from "../sessions/limits.ts";
import { TryLimit } from "./try-limit.ts";

export class GuessGuard {
  readonly #byAddress = new Map<string, TryLimit>();
  readonly #all: TryLimit | null;
  readonly #codes: string;

  /**
   * @param codes what is guessed, in words for the client, such as "pairing codes"
   * @param isForAll whether wrong tries of everybody count together as well
   */
  constructor(codes: string, isForAll: boolean) {
    this.#codes = codes;
    this.#all = isForAll
      ? new TryLimit({ wrong: limits.wrongCodes, delay: limits.wrongCodeDelayForAll })
      : null;
  }

  /**
   * Counts a try, before anything is looked up.
   * @returns to be called when it was no wrong one
   * @throws Refusal too-fast, with the seconds to wait
   */
  begin(from: string, now: number): () => void {
    const own = this.#byAddress.get(from) ?? ownLimit();
    const ownWaitMs = own.waitMs(now);
    if (ownWaitMs > 0) {
      throw tooMany(`Too many wrong ${this.#codes} came from this network.`, ownWaitMs);
    }
    const waitMs = this.#all?.waitMs(now) ?? 0;
    if (waitMs > 0) throw tooMany(`Too many wrong ${this.#codes} came to this service.`, waitMs);
    this.#byAddress.set(from, own);
    const rights = [own.begin(now), this.#all?.begin(now)];
    return () => {
      for (const right of rights) right?.();
    };
  }

  /** Forgets addresses from which nothing wrong came of late. */
  forget(now: number): void {
    for (const [from, limit] of this.#byAddress) {
      if (limit.isFresh(now)) this.#byAddress.delete(from);
    }
  }
}

function ownLimit(): TryLimit {
  return new TryLimit({ wrong: limits.wrongCodesPerAddress, delay: limits.wrongCodeDelay });
}

function tooMany(what: string, waitMs: number): Refusal {
  return new Refusal("too-fast", `${what} Wait a moment, then type the code with care.`, {
    headers: retryAfter(waitMs),
  });
}
