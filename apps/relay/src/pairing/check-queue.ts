/**
 * Slows down guessing of codes without a lockout. The codes of one address are checked one at a
 * time in order of arrival, and a wrong code delays the next check. A right code adds no delay, so
 * a class that types right codes never waits. Wrong codes from the same network delay a right code
 * but never block it.
 */
import type { Clock } from "../clock.ts";
import { Refusal, restarting, retryAfter } from "../problems.ts";

export interface CheckQueueRule {
  /** checks per second after wrong codes */
  perSecond: number;
  /** maximum number of pending checks; further checks are rejected */
  waiting: number;
}

/** @returns null if the code does not exist */
type Check<T> = () => Promise<T | null>;

interface PendingCheck {
  start(): Promise<"right" | "wrong">;
  cancel(): void;
}

/** Serial queue of checks, for one address or for all. */
class SerialQueue {
  readonly #pending: PendingCheck[] = [];
  readonly #clock: Clock;
  readonly #rule: CheckQueueRule;
  readonly #onIdle: () => void;
  #isBusy = false;

  /** @param onIdle called when no check is pending and the delay of a wrong code has passed */
  constructor(clock: Clock, rule: CheckQueueRule, onIdle: () => void = () => undefined) {
    this.#clock = clock;
    this.#rule = rule;
    this.#onIdle = onIdle;
  }

  /** @throws Refusal too-fast if too many checks wait, restarting if the queue closes */
  async run<T>(check: Check<T>): Promise<T | null> {
    if (this.#pending.length >= this.#rule.waiting) throw tooMany();
    return new Promise<T | null>((resolve, reject) => {
      this.#pending.push({
        start: async () => {
          try {
            const found = await check();
            resolve(found);
            return found === null ? "wrong" : "right";
          } catch (error) {
            // A store failure does not show whether the code is right.
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
    for (const waiting of this.#pending.splice(0)) waiting.cancel();
  }

  async #next(): Promise<void> {
    this.#isBusy = true;
    for (let next = this.#pending.shift(); next !== undefined; next = this.#pending.shift()) {
      const outcome = await next.start();
      if (outcome === "wrong") {
        await new Promise<void>((resolve) => {
          this.#clock.after(1_000 / this.#rule.perSecond, resolve);
        });
      }
    }
    this.#isBusy = false;
    this.#onIdle();
  }
}

export class CheckQueue {
  readonly #queues = new Map<string, SerialQueue>();
  readonly #clock: Clock;
  readonly #rule: CheckQueueRule;
  readonly #all: SerialQueue | null;

  /**
   * @param rule limit for each address
   * @param ruleForAll limit for all addresses together; null: no limit
   */
  constructor(clock: Clock, rule: CheckQueueRule, ruleForAll: CheckQueueRule | null) {
    this.#clock = clock;
    this.#rule = rule;
    this.#all = ruleForAll && new SerialQueue(clock, ruleForAll);
  }

  /**
   * Runs a check in the queue of its address.
   * @throws Refusal too-fast with the seconds to wait if too many checks are pending; the code is
   * not checked
   */
  async run<T>(address: string, check: Check<T>): Promise<T | null> {
    const all = this.#all;
    return this.#queueOf(address).run(all === null ? check : async () => all.run(check));
  }

  /** Number of addresses with a pending check or delay. */
  get size(): number {
    return this.#queues.size;
  }

  /** Rejects all pending checks. */
  close(): void {
    this.#all?.close();
    for (const queue of this.#queues.values()) queue.close();
  }

  #queueOf(address: string): SerialQueue {
    const open = this.#queues.get(address);
    if (open !== undefined) return open;
    const queue = new SerialQueue(this.#clock, this.#rule, () => this.#queues.delete(address));
    this.#queues.set(address, queue);
    return queue;
  }
}

function tooMany(): Refusal {
  return new Refusal(
    "too-fast",
    "Too many codes from this network are waiting. This code was not checked. Send it again in a second.",
    { headers: retryAfter(1_000) },
  );
}
