/**
 * What one reader of a robot gets: every state of a command, and snapshots at most 20 times a second,
 * the newest each time. A reader that is slow gets fewer snapshots; one that does not read is dropped.
 */
import type { CommandRecord, Snapshot } from "@corridor/protocol";
import type { Clock } from "../clock.ts";
import type { ReaderDoor } from "./audience.ts";
import { limits } from "./limits.ts";

/** Where the reader is, in whichever dialect it speaks. */
export interface ReaderSink {
  readonly door: Exclude<ReaderDoor, "long-poll">;
  snapshot(snapshot: Snapshot): void;
  state(record: CommandRecord): void;
  /** the session is over, or the relay stops */
  over(reason: "over" | "restart" | "tooSlow"): void;
  /** bytes on their way to the reader */
  waitingBytes(): number;
}

export class ReaderFeed {
  readonly #sink: ReaderSink;
  readonly #clock: Clock;
  #pending: Snapshot | null = null;
  #cancelTimer: (() => void) | null = null;

  constructor(sink: ReaderSink, clock: Clock) {
    this.#sink = sink;
    this.#clock = clock;
  }

  /** Offers a snapshot; it is sent now, later, or never when a newer one comes first. */
  snapshot(snapshot: Snapshot): void {
    this.#pending = snapshot;
    if (this.#cancelTimer === null) this.#flush();
  }

  /** Sends a command's new state, after the snapshot that was taken before it. */
  state(record: CommandRecord): void {
    if (this.#sink.waitingBytes() > limits.stuckReaderBytes) return this.over("tooSlow");
    if (this.#pending !== null) this.#sink.snapshot(this.#pending);
    this.#pending = null;
    this.#sink.state(record);
  }

  over(reason: "over" | "restart" | "tooSlow"): void {
    this.close();
    this.#sink.over(reason);
  }

  /** Sends nothing any more. */
  close(): void {
    this.#pending = null;
    this.#cancelTimer?.();
    this.#cancelTimer = null;
  }

  #flush(): void {
    if (this.#pending !== null && this.#sink.waitingBytes() <= limits.slowReaderBytes) {
      this.#sink.snapshot(this.#pending);
      this.#pending = null;
    }
    this.#cancelTimer = this.#clock.after(limits.snapshotIntervalMs, () => {
      this.#cancelTimer = null;
      if (this.#pending !== null) this.#flush();
    });
  }
}
