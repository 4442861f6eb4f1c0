/**
 * Subscriptions of one client. Several to one topic count as one, with the lowest throttle rate. The
 * newest message wins: what is published meanwhile is dropped.
 */
import { RosError } from "./ros-error.ts";
import type { Timers } from "./timers.ts";

/** At most 20 messages a second of each topic. */
const MIN_INTERVAL_MS = 50;
const MAX_SUBSCRIPTIONS = 256;

interface Subscribed {
  /** ms between two messages, by the id of the subscription */
  readonly intervals: Map<string, number>;
  sentAt: number | null;
  /** makes the newest message that has not been sent */
  next: (() => object | null) | null;
  cancelTimer: (() => void) | null;
}

export class Subscriptions {
  readonly #timers: Timers;
  readonly #send: (topic: string, message: object) => void;
  readonly #topics = new Map<string, Subscribed>();
  #count = 0;

  constructor(timers: Timers, send: (topic: string, message: object) => void) {
    this.#timers = timers;
    this.#send = send;
  }

  has(topic: string): boolean {
    return this.#topics.has(topic);
  }

  /**
   * Adds a subscription, or replaces the one with the same id.
   * @param throttleRate ms
   * @throws RosError if the client has too many
   */
  add(topic: string, id: string, throttleRate: number): void {
    const subscribed = this.#topics.get(topic) ?? {
      intervals: new Map<string, number>(),
      sentAt: null,
      next: null,
      cancelTimer: null,
    };
    if (!subscribed.intervals.has(id)) {
      if (this.#count >= MAX_SUBSCRIPTIONS) {
        throw new RosError(
          `This connection has ${MAX_SUBSCRIPTIONS} subscriptions, the maximum. Unsubscribe first.`,
        );
      }
      this.#count += 1;
    }
    subscribed.intervals.set(id, Math.max(MIN_INTERVAL_MS, throttleRate));
    this.#topics.set(topic, subscribed);
  }

  /** @param id null: all of the topic */
  remove(topic: string, id: string | null): void {
    const subscribed = this.#topics.get(topic);
    if (subscribed === undefined) return;
    const { intervals } = subscribed;
    const before = intervals.size;
    if (id === null) intervals.clear();
    else intervals.delete(id);
    this.#count -= before - intervals.size;
    if (intervals.size > 0) return;
    subscribed.cancelTimer?.();
    this.#topics.delete(topic);
  }

  /** @param make makes the message when it is sent; null: there is none */
  publish(topic: string, make: () => object | null): void {
    const subscribed = this.#topics.get(topic);
    if (subscribed === undefined) return;
    subscribed.next = make;
    if (subscribed.cancelTimer !== null) return;
    const { sentAt } = subscribed;
    const dueAt = sentAt === null ? 0 : sentAt + Math.min(...subscribed.intervals.values());
    const waitMs = dueAt - this.#timers.now();
    if (waitMs <= 0) return this.#sendNext(topic, subscribed);
    subscribed.cancelTimer = this.#timers.after(waitMs, () => {
      subscribed.cancelTimer = null;
      this.#sendNext(topic, subscribed);
    });
  }

  close(): void {
    for (const topic of this.#topics.keys()) this.remove(topic, null);
  }

  #sendNext(topic: string, subscribed: Subscribed): void {
    const message = subscribed.next?.() ?? null;
    subscribed.next = null;
    if (message === null) return;
    subscribed.sentAt = this.#timers.now();
    this.#send(topic, message);
  }
}
