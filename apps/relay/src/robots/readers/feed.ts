/**
 * Feed of one reader: every state of a command in order, and the newest snapshot at most 20 times a
 * second.
 *
 * Buffers on the network path can hold megabytes for a reader that sleeps. So the feed limits what
 * the reader has not yet taken: two snapshots and some states. Other states wait in the event log.
 * A reader that sleeps for longer than the log lasts receives a gap.
 */
import {
  hasEnded,
  type CommandRecord,
  type EventGap,
  type Marks,
  type StateEvent,
} from "@corridor/protocol";
import type { Clock } from "../../platform/time/clock.ts";
import {
  dueAfter,
  type CoalescedTimers,
  type Waiter,
} from "../../platform/time/coalesced-timers.ts";
import type { DismissalReason, ReaderTransport } from "./subscribers.ts";
import type { CarriedSnapshot } from "../../bus/carried-snapshot.ts";
import type { EventLog } from "../../platform/events/event-log.ts";
import { limits } from "../../platform/limits/limits.ts";

/** Progress of a reader, in bytes of its connection. */
export interface ReaderFlow {
  readonly sentBytes: number;
  /** bytes that the reader has taken, as far as known */
  readonly takenBytes: number;
  /** Requests the reader's position. The response changes `takenBytes`, or never arrives. */
  ask(): void;
  /** whether the reader confirms `takenBytes`; otherwise they have only left this process */
  readonly isProof: boolean;
}

/** Start position of a reader. */
export interface ReaderStart {
  stream: string;
  /** states after this one follow; null: a gap follows */
  n: number | null;
  snapshot: CarriedSnapshot | null;
}

/** The reader's end of a feed, independent of the transport. */
export interface ReaderSink {
  readonly transport: Exclude<ReaderTransport, "long-poll">;
  readonly flow: ReaderFlow;
  /** Sends the first message. */
  began(start: ReaderStart): void;
  snapshot(snapshot: CarriedSnapshot): void;
  state(event: StateEvent): void;
  gap(gap: EventGap): void;
  /** the robot's maze has changed */
  maze(version: string): void;
  /** a script has marked cells; not sent to readers that do not show them */
  marks?(marks: Marks): void;
  /** the reader may no longer read, the relay stops, or the reader cannot be served */
  over(reason: OverReason): void;
}

export type OverReason = DismissalReason | "tooSlow";

/** The data that readers read. */
export interface ReaderSource {
  readonly events: EventLog<CommandRecord>;
  newest(): CarriedSnapshot | null;
  /** Reports the commands that have not ended, between two changes. @throws if the store fails */
  readOpen(notify: (open: EventGap["open"]) => void): Promise<void>;
}

/** A snapshot in transit, and its end position on the connection. */
interface OnTheWay {
  seq: number;
  end: number;
}

export class ReaderFeed implements Waiter {
  readonly #sink: ReaderSink;
  readonly #source: ReaderSource;
  readonly #clock: Clock;
  readonly #timers: CoalescedTimers;
  /** number of the newest state that was sent */
  #n = 0;
  /**
   * states wait in the log: the reader has not started, takes nothing, or must receive a gap first
   */
  #isHeld = true;
  #isMissing = false;
  #isClosed = false;
  #pending: CarriedSnapshot | null = null;
  /** no snapshot is due before this time, except one that precedes a state */
  #notBefore = -Infinity;
  #onTheWay: OnTheWay[] = [];
  /** whether the reader itself reports what it has read; until then its connection does */
  #saysSeen = false;
  #seenBytes = 0;
  /** whether a timer is pending */
  #isArmed = false;

  constructor(
    sink: ReaderSink,
    source: ReaderSource,
    { clock, timers }: { clock: Clock; timers: CoalescedTimers },
  ) {
    this.#sink = sink;
    this.#source = source;
    this.#clock = clock;
    this.#timers = timers;
  }

  /**
   * Sends the start position, and missed states or a gap.
   * @param since resume position; null for a new reader
   */
  begin(since: string | null): void {
    const { events } = this.#source;
    const position = since === null ? events.n : events.numberOf(since);
    const isMissing = position === null || !events.hasAfter(position);
    this.#n = position ?? 0;
    const snapshot = this.#source.newest();
    this.#sink.began({ stream: events.stream, n: isMissing ? null : this.#n, snapshot });
    if (snapshot !== null) this.#left(snapshot);
    if (isMissing) this.#missed();
    else this.#catchUp();
  }

  /** Offers a snapshot. It is sent now, later, or never if a newer one replaces it. */
  snapshot(snapshot: CarriedSnapshot): void {
    this.#pending = snapshot;
    if (!this.#isArmed) this.#flush();
  }

  /** Sends a command's new state. An ending follows the snapshot that was taken before it. */
  state(event: StateEvent): void {
    const { isProof } = this.#sink.flow;
    if (!isProof && this.#unread > limits.stuckReaderBytes) return this.over("tooSlow");
    if (this.#isFull) this.#isHeld = true;
    if (this.#isHeld) this.#arm();
    else this.#notify(event);
  }

  /** States were missed: the reader receives a gap. */
  missed(): void {
    if (!this.#isMissing) this.#missed();
  }

  /** Reports a changed maze immediately, because such messages are rare and short. */
  maze(version: string): void {
    this.#sink.maze(version);
  }

  /** Marks are repeated by their script, so those for a slow reader are discarded. */
  marks(marks: Marks): void {
    if (this.#unread <= limits.heldReaderBytes) this.#sink.marks?.(marks);
  }

  /** The reader has read everything up to this snapshot. */
  seen(seq: number): void {
    this.#saysSeen = true;
    for (const { seq: each, end } of this.#onTheWay) {
      if (each <= seq) this.#seenBytes = Math.max(this.#seenBytes, end);
    }
    this.#onTheWay = this.#onTheWay.filter((each) => each.seq > seq);
    // The pending snapshot may have waited for this.
    if (this.#pending !== null && this.#clock.now() >= this.#notBefore) this.#flush();
  }

  over(reason: OverReason): void {
    this.close();
    this.#sink.over(reason);
  }

  /** Stops sending. */
  close(): void {
    this.#isClosed = true;
    this.#pending = null;
  }

  get #unread(): number {
    const { sentBytes, takenBytes } = this.#sink.flow;
    return sentBytes - Math.max(takenBytes, this.#seenBytes);
  }

  get #isFull(): boolean {
    return this.#sink.flow.isProof && this.#unread > limits.heldReaderBytes;
  }

  get #hasCredit(): boolean {
    if (!this.#saysSeen) {
      const { takenBytes } = this.#sink.flow;
      this.#onTheWay = this.#onTheWay.filter(({ end }) => end > takenBytes);
    }
    return this.#onTheWay.length < limits.snapshotCredit;
  }

  #flush(): void {
    const now = this.#clock.now();
    if (now < this.#notBefore) return this.#arm(this.#notBefore - now);
    if (this.#isHeld) this.#catchUp();
    if (this.#pending !== null && this.#hasCredit) this.#sendSnapshot(this.#pending, now);
    if (this.#waits) this.#arm();
  }

  /** Whether a snapshot or states wait, for their time or for the reader. */
  get #waits(): boolean {
    return this.#pending !== null || (this.#isHeld && !this.#isMissing);
  }

  /** Sets the timer, unless one is pending. */
  #arm(ms: number = this.#pauseMs): void {
    if (this.#isArmed) return;
    this.#isArmed = true;
    this.#timers.wakeAfter(ms, this);
  }

  wake(): void {
    this.#isArmed = false;
    if (this.#waits && !this.#isClosed) this.#flush();
  }

  get #pauseMs(): number {
    return this.#sink.transport === "long-poll-connection"
      ? limits.longPollSnapshotIntervalMs
      : limits.snapshotIntervalMs;
  }

  #catchUp(): void {
    if (this.#isMissing || this.#isClosed) return;
    const events = this.#source.events.after(this.#n);
    if (events === null) return this.#missed();
    this.#isHeld = false;
    for (const event of events) {
      // The previous state may have closed the feed.
      if (this.#isClosed) return;
      if (this.#isFull) {
        this.#isHeld = true;
        return this.#arm();
      }
      this.#notify(event);
    }
  }

  #missed(): void {
    this.#isMissing = true;
    const position = this.#source.readOpen((open) => {
      if (this.#isClosed) return;
      this.#isMissing = false;
      this.#isHeld = false;
      this.#n = this.#source.events.n;
      this.#sink.gap({ n: this.#n, open });
      const newest = this.#source.newest();
      if (newest !== null) this.snapshot(newest);
    });
    position.catch(() => this.over("busy"));
  }

  #notify(event: StateEvent): void {
    if (this.#pending !== null && (hasEnded(event.record.state) || this.#hasCredit)) {
      this.#sendSnapshot(this.#pending, this.#clock.now());
    }
    this.#sink.state(event);
    this.#n = event.n;
    if (this.#unread > limits.askReaderBytes) this.#sink.flow.ask();
  }

  #sendSnapshot(snapshot: CarriedSnapshot, now: number): void {
    this.#pending = null;
    this.#notBefore = dueAfter(this.#notBefore, now, this.#pauseMs);
    this.#sink.snapshot(snapshot);
    this.#left(snapshot);
  }

  #left({ seq }: CarriedSnapshot): void {
    const { flow } = this.#sink;
    // The seq has fallen, so the reader can no longer confirm the higher ones.
    if (this.#onTheWay.some((each) => each.seq >= seq)) this.#onTheWay = [];
    this.#onTheWay.push({ seq, end: flow.sentBytes });
    if (!this.#saysSeen) flow.ask();
  }
}
