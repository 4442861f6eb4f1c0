/**
 * Subscriptions of one client. Several to one topic count as one, with the lowest throttle rate. The
 * newest message wins: what is published meanwhile is dropped.
 */
import { RosError } from "./ros-error.ts";
import type { Timers } from "@corridor/protocol";

/** At most 20 messages a second of each topic. */
const MIN_INTERVAL_MS = 50;
const MAX_SUBSCRIPTIONS = 256;

interface Subscription {
  /** as the client sent it, or "" */
  id: string;
  /** the topic as the client wrote it, with or without a slash: its library calls back for this name */
  name: string;
  /** ms between two messages */
  interval: number;
}

interface Subscribed {
  readonly subscriptions: Subscription[];
  sentAt: number | null;
  /** makes the newest message that has not been sent */
  next: (() => object | null) | null;
  cancelTimer: (() => void) | null;
}

export class Subscriptions {
  readonly #timers: Timers;
  readonly #send: (name: string, message: object) => void;
  readonly #topics = new Map<string, Subscribed>();
  #count = 0;

  constructor(timers: Timers, send: (name: string, message: object) => void) {
    this.#timers = timers;
    this.#send = send;
  }

  /**
   * Adds a subscription, or replaces the one with the same id and name.
   * @param name the topic as the client wrote it
   * @param throttleRate ms
   * @throws RosError if the client has too many
   */
  add(
    topic: string,
    { id, name, throttleRate }: { id: string; name: string; throttleRate: number },
  ): void {
    const subscribed = this.#topics.get(topic) ?? {
      subscriptions: [],
      sentAt: null,
      next: null,
      cancelTimer: null,
    };
    const interval = Math.max(MIN_INTERVAL_MS, throttleRate);
    const same = subscribed.subscriptions.find((each) => each.id === id && each.name === name);
    if (same !== undefined) {
      same.interval = interval;
      return this.#reschedule(subscribed);
    }
    if (this.#count >= MAX_SUBSCRIPTIONS) {
      throw new RosError(
        `This connection has ${MAX_SUBSCRIPTIONS} subscriptions, the maximum. Unsubscribe first.`,
      );
    }
    this.#count += 1;
    subscribed.subscriptions.push({ id, name, interval });
    this.#topics.set(topic, subscribed);
    this.#reschedule(subscribed);
  }

  /** @param id null: all of the topic */
  remove(topic: string, id: string | null): void {
    const subscribed = this.#topics.get(topic);
    if (subscribed === undefined) return;
    const { subscriptions } = subscribed;
    const removed = subscriptions.splice(0);
    if (id !== null) subscriptions.push(...removed.filter((each) => each.id !== id));
    this.#count -= removed.length - subscriptions.length;
    if (subscriptions.length > 0) return;
    subscribed.cancelTimer?.();
    this.#topics.delete(topic);
  }

  /** @param make makes the message when it is sent; null: there is none */
  publish(topic: string, make: () => object | null): void {
    const subscribed = this.#topics.get(topic);
    if (subscribed === undefined) return;
    subscribed.next = make;
    if (subscribed.cancelTimer === null) this.#schedule(subscribed);
  }

  close(): void {
    for (const topic of this.#topics.keys()) this.remove(topic, null);
  }

  /** A message that waits may be due earlier now. */
  #reschedule(subscribed: Subscribed): void {
    if (subscribed.cancelTimer === null) return;
    subscribed.cancelTimer();
    subscribed.cancelTimer = null;
    this.#schedule(subscribed);
  }

  #schedule(subscribed: Subscribed): void {
    const { sentAt } = subscribed;
    const dueAt = sentAt === null ? 0 : sentAt + leastInterval(subscribed);
    const waitMs = dueAt - this.#timers.now();
    if (waitMs <= 0) return this.#sendNext(subscribed);
    subscribed.cancelTimer = this.#timers.after(waitMs, () => {
      subscribed.cancelTimer = null;
      this.#sendNext(subscribed);
    });
  }

  #sendNext(subscribed: Subscribed): void {
    const message = subscribed.next?.() ?? null;
    subscribed.next = null;
    if (message === null) return;
    subscribed.sentAt = this.#timers.now();
    const names = new Set(subscribed.subscriptions.map(({ name }) => name));
    for (const name of names) this.#send(name, message);
  }
}

function leastInterval({ subscriptions }: Subscribed): number {
  return Math.min(...subscriptions.map(({ interval }) => interval));
}
