/**
 * What one reader of a robot gets: every state of a command, in order, and snapshots at most 20 times a
 * second, the newest each time.
 *
 * What left this process may still lie in buffers on the way, megabytes of it, for a reader that
 * sleeps. So no more is sent than the reader is known to take: two snapshots, and some states. The other
 * states wait in the event log; who sleeps for longer than that lasts is told of the gap.
 */
import { hasEnded, type EventGap, type StateEvent } from "@corridor/protocol";
import type { Clock } from "../clock.ts";
import { dueAfter, type CoalescedTimers, type Waiter } from "../coalesced-timers.ts";
import type { AwayReason, ReaderDoor } from "./audience.ts";
import type { CarriedSnapshot } from "./carried-snapshot.ts";
import type { EventLog } from "./event-log.ts";
import { limits } from "./limits.ts";

/** How far a reader has come, by the bytes of its line. */
export interface ReaderFlow {
  readonly sentBytes: number;
  /** how many of these it has taken, as far as is known */
  readonly takenBytes: number;
  /** Asks the line how far it is; the answer changes `takenBytes`, or never comes. */
  ask(): void;
  /** whether `takenBytes` is what the reader has taken, not only what has left this process */
  readonly isProof: boolean;
}

/** Where a reader begins. */
export interface ReaderStart {
  stream: string;
  /** states after this one follow; null when a gap follows */
  n: number | null;
  snapshot: CarriedSnapshot | null;
}

/** Where the reader is, in whichever dialect it speaks. */
export interface ReaderSink {
  readonly door: Exclude<ReaderDoor, "long-poll">;
  readonly flow: ReaderFlow;
  /** The first that it gets. */
  began(start: ReaderStart): void;
  snapshot(snapshot: CarriedSnapshot): void;
  state(event: StateEvent): void;
  gap(gap: EventGap): void;
  /** the robot is in another maze */
  maze(version: string): void;
  /** it may not read any more, the relay stops, or it cannot be served */
  over(reason: OverReason): void;
}

export type OverReason = AwayReason | "tooSlow";

/** What is read. */
export interface ReaderSource {
  readonly events: EventLog;
  newest(): CarriedSnapshot | null;
  /** Tells the commands that have not ended, between two changes. @throws when the store fails */
  tellOpen(tell: (open: EventGap["open"]) => void): Promise<void>;
}

/** A snapshot on its way, and where it ends on the line. */
interface OnTheWay {
  seq: number;
  end: number;
}

export class ReaderFeed implements Waiter {
  readonly #sink: ReaderSink;
  readonly #source: ReaderSource;
  readonly #clock: Clock;
  readonly #timers: CoalescedTimers;
  /** the newest state that was told */
  #n = 0;
  /** states wait in the log: the reader has not begun, takes nothing, or is to be told of a gap */
  #isHeld = true;
  #isMissing = false;
  #isClosed = false;
  #pending: CarriedSnapshot | null = null;
  /** no snapshot is due before this time, but for one that belongs before an ending */
  #notBefore = -Infinity;
  #onTheWay: OnTheWay[] = [];
  /** the reader says itself what it has seen; until then its line answers for it */
  #saysSeen = false;
  #seenBytes = 0;
  /** it will be woken */
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

  /** Welcomes the reader. @param since the last state that it was told; null for a new one */
  begin(since: string | null): void {
    const { events } = this.#source;
    const told = since === null ? events.n : events.numberOf(since);
    const isMissing = told === null || !events.hasAfter(told);
    this.#n = told ?? 0;
    const snapshot = this.#source.newest();
    this.#sink.began({ stream: events.stream, n: isMissing ? null : this.#n, snapshot });
    if (snapshot !== null) this.#left(snapshot);
    if (isMissing) this.#missed();
    else this.#catchUp();
  }

  /** Offers a snapshot; it is sent now, later, or never when a newer one comes first. */
  snapshot(snapshot: CarriedSnapshot): void {
    this.#pending = snapshot;
    if (!this.#isArmed) this.#flush();
  }

  /** Sends a command's new state; an ending after the snapshot that was taken before it. */
  state(event: StateEvent): void {
    const { isProof } = this.#sink.flow;
    if (!isProof && this.#unread > limits.stuckReaderBytes) return this.over("tooSlow");
    if (this.#isFull) this.#isHeld = true;
    if (this.#isHeld) this.#arm();
    else this.#tell(event);
  }

  /** States were lost: the reader is told of the gap. */
  missed(): void {
    if (!this.#isMissing) this.#missed();
  }

  /** Tells at once that the robot is in another maze: that is rare, and short. */
  maze(version: string): void {
    this.#sink.maze(version);
  }

  /** The reader has read all that came up to this snapshot. */
  seen(seq: number): void {
    this.#saysSeen = true;
    for (const { seq: each, end } of this.#onTheWay) {
      if (each <= seq) this.#seenBytes = Math.max(this.#seenBytes, end);
    }
    this.#onTheWay = this.#onTheWay.filter((each) => each.seq > seq);
    // It may be what the newest one waited for.
    if (this.#pending !== null && this.#clock.now() >= this.#notBefore) this.#flush();
  }

  over(reason: OverReason): void {
    this.close();
    this.#sink.over(reason);
  }

  /** Sends nothing any more. */
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

  /** Something waits for its time, or for the reader to take what came before. */
  get #waits(): boolean {
    return this.#pending !== null || (this.#isHeld && !this.#isMissing);
  }

  /** Looks again in a moment. */
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
    return this.#sink.door === "line" ? limits.lineSnapshotIntervalMs : limits.snapshotIntervalMs;
  }

  #catchUp(): void {
    if (this.#isMissing || this.#isClosed) return;
    const events = this.#source.events.after(this.#n);
    if (events === null) return this.#missed();
    this.#isHeld = false;
    for (const event of events) {
      // What was told before may have ended it.
      if (this.#isClosed) return;
      if (this.#isFull) {
        this.#isHeld = true;
        return this.#arm();
      }
      this.#tell(event);
    }
  }

  #missed(): void {
    this.#isMissing = true;
    const told = this.#source.tellOpen((open) => {
      if (this.#isClosed) return;
      this.#isMissing = false;
      this.#isHeld = false;
      this.#n = this.#source.events.n;
      this.#sink.gap({ n: this.#n, open });
      const newest = this.#source.newest();
      if (newest !== null) this.snapshot(newest);
    });
    told.catch(() => this.over("busy"));
  }

  #tell(event: StateEvent): void {
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
    // A number that falls: nobody will say that of the ones above it any more.
    if (this.#onTheWay.some((each) => each.seq >= seq)) this.#onTheWay = [];
    this.#onTheWay.push({ seq, end: flow.sentBytes });
    if (!this.#saysSeen) flow.ask();
  }
}
