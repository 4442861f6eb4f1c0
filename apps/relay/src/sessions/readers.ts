/** The ways in which one robot is read: followed on a line, or asked for what is next. */
import type { EventPage, Snapshot } from "@corridor/protocol";
import type { Clock } from "../clock.ts";
import type { CoalescedTimers } from "../coalesced-timers.ts";
import type { Audience, Patience, ReaderDoor } from "./audience.ts";
import type { DriverRoster } from "./driver-roster.ts";
import { nextEvents, type WantedEvents } from "./next-events.ts";
import { ReaderFeed, type ReaderSink, type ReaderSource } from "./reader-feed.ts";
import type { Caller } from "./script.ts";

/** A reader's hold on the session. */
export interface JoinedReader {
  /** It has read all that came up to this snapshot. */
  seen(seq: number): void;
  leave(): void;
}

export interface ReadersParts {
  clock: Clock;
  timers: CoalescedTimers;
  audience: Audience;
  /** what is read: one for all readers */
  source: ReaderSource;
  roster: DriverRoster;
}

export class Readers {
  readonly #parts: ReadersParts;

  constructor(parts: ReadersParts) {
    this.#parts = parts;
  }

  /** How many there are, by the way in which they follow. */
  get count(): Record<ReaderDoor, number> {
    return this.#parts.audience.count();
  }

  /**
   * Joins a reader of snapshots and states, and welcomes it.
   * @param since the last state that it was told before; null for a new reader
   * @throws Refusal when too many read already
   */
  join(caller: Caller, sink: ReaderSink, since: string | null): JoinedReader {
    const { clock, timers, audience, source, roster } = this.#parts;
    const feed = new ReaderFeed(sink, source, { clock, timers });
    const leave = audience.join(feed, caller, sink.door);
    const { script } = caller;
    const disconnected = script === null ? () => undefined : roster.connected(script);
    feed.begin(since);
    return {
      seen: (seq) => feed.seen(seq),
      leave: () => {
        feed.close();
        if (leave()) disconnected();
      },
    };
  }

  /** The states after `since`, and the newest snapshot: see `nextEvents`. */
  async nextEvents(wanted: WantedEvents, patience: Patience): Promise<EventPage> {
    const { source, audience } = this.#parts;
    return nextEvents({ ...source, audience }, wanted, patience);
  }

  /** Waits for a snapshot newer than `after`, or for the robot to go. @returns the newest then */
  async nextSnapshot(after: number, patience: Patience): Promise<Snapshot | null> {
    const { audience, source } = this.#parts;
    const before = source.newest();
    if (before !== null && before.seq > after) return before.value;
    await audience.until(patience, (done) => ({
      snapshot: ({ seq, state }) => {
        if (seq > after || state !== before?.state) done();
      },
    }));
    return source.newest()?.value ?? null;
  }
}
