/**
 * Slows down the guessing of codes without a lockout. The codes of one address are checked in order of arrival, one
 * at a time, and a wrong one delays the next check. A right code costs no delay, so a class that types right codes
 * never waits, and a neighbour's wrong codes delay a right one but never refuse it.
 */
import type { Clock } from "../clock.ts";
import { Refusal, restarting, retryAfter } from "../problems.ts";

export interface CheckQueueRule {
  /** checks a second after wrong codes */
  perSecond: number;
  /** checks that wait; one more is refused */
  waiting: number;
}

/** @returns null where no such code exists */
type Check<T> = () => Promise<T | null>;

interface Waiting {
  start(): Promise<"right" | "wrong">;
  cancel(): void;
}

/** Checks of one address, or of all. */
class Lane {
  readonly #waiting: Waiting[] = [];
  readonly #clock: Clock;
  readonly #rule: CheckQueueRule;
  readonly #ended: () => void;
  #isBusy = false;

  /** @param ended is called when nothing waits and the delay of a wrong code is over */
  constructor(clock: Clock, rule: CheckQueueRule, ended: () => void = () => undefined) {
    this.#clock = clock;
    this.#rule = rule;
    this.#ended = ended;
  }

  /** @throws Refusal too-fast when too many wait; restarting when the lane closes */
  async run<T>(check: Check<T>): Promise<T | null> {
    if (this.#waiting.length >= this.#rule.waiting) throw tooMany();
    return new Promise<T | null>((resolve, reject) => {
      this.#waiting.push({
        start: async () => {
          try {
            const found = await check();
            resolve(found);
            return found === null ? "wrong" : "right";
          } catch (error) {
            // A store that does not answer says nothing about the code.
            reject(error);
            return "right";
          }
        },
        cancel: () => reject(restarting()),
      });
      if (!this.#isBusy) void this.#next();
    });
  }

  close(): void {
    for (const waiting of this.#waiting.splice(0)) waiting.cancel();
  }

  async #next(): Promise<void> {
    this.#isBusy = true;
    for (let next = this.#waiting.shift(); next !== undefined; next = this.#waiting.shift()) {
      const outcome = await next.start();
      if (outcome === "wrong") {
        await new Promise<void>((resolve) => {
          this.#clock.after(1_000 / this.#rule.perSecond, resolve);
        });
      }
    }
    this.#isBusy = false;
    this.#ended();
  }
}

export class CheckQueue {
  readonly #lanes = new Map<string, Lane>();
  readonly #clock: Clock;
  readonly #rule: CheckQueueRule;
  readonly #all: Lane | null;

  /**
   * @param rule for one address
   * @param ruleForAll for all addresses together; null: no limit
   */
  constructor(clock: Clock, rule: CheckQueueRule, ruleForAll: CheckQueueRule | null) {
    this.#clock = clock;
    this.#rule = rule;
    this.#all = ruleForAll && new Lane(clock, ruleForAll);
  }

  /**
   * Runs a check when it is the turn of its address.
   * @throws Refusal too-fast with the seconds to wait when too many checks wait; no code was checked then
   */
  async run<T>(address: string, check: Check<T>): Promise<T | null> {
    const all = this.#all;
    return this.#laneOf(address).run(all === null ? check : async () => all.run(check));
  }

  /** Addresses with a check that waits, or a delay that is not over. */
  get size(): number {
    return this.#lanes.size;
  }

  /** Refuses all checks that wait. */
  close(): void {
    this.#all?.close();
    for (const lane of this.#lanes.values()) lane.close();
  }

  #laneOf(address: string): Lane {
    const open = this.#lanes.get(address);
    if (open !== undefined) return open;
    const lane = new Lane(this.#clock, this.#rule, () => this.#lanes.delete(address));
    this.#lanes.set(address, lane);
    return lane;
  }
}

function tooMany(): Refusal {
  return new Refusal(
    "too-fast",
    "Many codes from this network wait to be checked. This code was not checked: send it again in a second.",
    { headers: retryAfter(1_000) },
  );
}
