/** Ways to read one robot: subscribe on a connection, or request the next events. */
import type { EventPage, Snapshot } from "@corridor/protocol";
import type { Clock } from "../../platform/time/clock.ts";
import type { CoalescedTimers } from "../../platform/time/coalesced-timers.ts";
import type { Subscribers, CallerWait, ReaderTransport } from "./subscribers.ts";
import type { Presence } from "../presence/presence.ts";
import { nextEvents, type WantedEvents } from "./next-events.ts";
import { ReaderFeed, type ReaderSink, type ReaderSource } from "./feed.ts";
import type { Caller } from "../access/callers.ts";

/** A reader's subscription. */
export interface JoinedReader {
  /** The reader has read everything up to this snapshot. */
  seen(seq: number): void;
  leave(): void;
}

export interface ReadersParts {
  clock: Clock;
  timers: CoalescedTimers;
  subscribers: Subscribers;
  /** shared by all readers */
  source: ReaderSource;
  presence: Presence;
}

export class Readers {
  readonly #parts: ReadersParts;

  constructor(parts: ReadersParts) {
    this.#parts = parts;
  }

  /** Number of readers by kind of subscription. */
  get count(): Record<ReaderTransport, number> {
    return this.#parts.subscribers.count();
  }

  /**
   * Subscribes a reader to snapshots and states, and sends its start position.
   * @param since resume position; null for a new reader
   * @throws Refusal too-many-readers
   */
  join(caller: Caller, sink: ReaderSink, since: string | null): JoinedReader {
    const { clock, timers, subscribers, source, presence } = this.#parts;
    const feed = new ReaderFeed(sink, source, { clock, timers });
    const leave = subscribers.join(feed, caller, sink.transport);
    const { script } = caller;
    const disconnected = script === null ? () => undefined : presence.connected(script);
    feed.begin(since);
    return {
      seen: (seq) => feed.seen(seq),
      leave: () => {
        feed.close();
        leave();
        disconnected();
      },
    };
  }

  /** The states after `since`, and the newest snapshot: see `nextEvents`. */
  async nextEvents(wanted: WantedEvents, waitLimit: CallerWait): Promise<EventPage> {
    const { source, subscribers } = this.#parts;
    return nextEvents({ ...source, subscribers }, wanted, waitLimit);
  }

  /**
   * Waits for a snapshot that is newer than `after` or has another state. @returns the newest one
   */
  async nextSnapshot(after: number, waitLimit: CallerWait): Promise<Snapshot | null> {
    const { subscribers, source } = this.#parts;
    const before = source.newest();
    if (before !== null && before.seq > after) return before.value;
    await subscribers.until(waitLimit, (done) => ({
      snapshot: ({ seq, state }) => {
        if (seq > after || state !== before?.state) done();
      },
    }));
    return source.newest()?.value ?? null;
  }
}
