/**
 * Everyone who follows one robot at this moment: the feeds of scripts that are connected, and requests
 * that wait for something to happen (long polls). They hear every change in the order in which it came.
 */
import type { CommandRecord, Snapshot, StateEvent } from "@corridor/protocol";
import type { Clock } from "../clock.ts";
import { Refusal, retryAfter } from "../problems.ts";
import type { EventLog } from "./event-log.ts";
import { limits } from "./limits.ts";

/** Whoever follows the robot: a reader's feed, or a request that waits. */
interface Listener {
  snapshot(snapshot: Snapshot): void;
  state(event: StateEvent): void;
  /** states may have been lost on the way here */
  missed(): void;
  over(reason: "over" | "restart"): void;
}

/** The ways in which a robot is followed. */
export type ReaderDoor = "websocket" | "line" | "events" | "long-poll";

/** How long somebody waits, and what makes them stop earlier. */
export interface Patience {
  milliseconds: number;
  signal: AbortSignal;
}

export class Audience {
  readonly #clock: Clock;
  readonly #events: EventLog;
  /** with the key that counts for the limit, or null for a request that waits */
  readonly #entries = new Set<{ listener: Listener; key: string | null; door: ReaderDoor }>();

  /** @param events numbers what is told, and keeps it for those who come back */
  constructor(clock: Clock, events: EventLog) {
    this.#clock = clock;
    this.#events = events;
  }

  get isEmpty(): boolean {
    return this.#entries.size === 0;
  }

  count(): Record<ReaderDoor, number> {
    const counts = { websocket: 0, line: 0, events: 0, "long-poll": 0 };
    for (const { door } of this.#entries) counts[door] += 1;
    return counts;
  }

  /**
   * Adds the feed of a connected script.
   * @param key hash of the script's key
   * @returns a function that lets it go; false from it: it was gone already
   * @throws Refusal when too many read already, with this key or at this robot
   */
  join(listener: Listener, key: string, door: ReaderDoor): () => boolean {
    const ofKey = [...this.#entries].filter((entry) => entry.key === key).length;
    if (ofKey >= limits.readersPerKey) {
      throw new Refusal(
        "too-many-readers",
        `${limits.readersPerKey} scripts are connected with this key. End one of them first.`,
        { headers: retryAfter(5000) },
      );
    }
    return this.#add(listener, key, door);
  }

  /**
   * Waits until `done` is called, until patience ends or until the session does.
   * @param listen what to listen for; calls `done` when it came
   * @throws Refusal when too many read already
   */
  async until(
    { milliseconds, signal }: Patience,
    listen: (done: () => void) => Partial<Pick<Listener, "snapshot" | "state">>,
  ): Promise<void> {
    if (milliseconds === 0 || signal.aborted) return;
    const { promise, resolve } = Promise.withResolvers<void>();
    const deaf = { snapshot: () => undefined, state: () => undefined };
    const leave = this.#add(
      { ...deaf, ...listen(resolve), missed: resolve, over: () => resolve() },
      null,
      "long-poll",
    );
    const cancelTimer = this.#clock.after(milliseconds, resolve);
    signal.addEventListener("abort", () => resolve(), { once: true });
    await promise;
    cancelTimer();
    leave();
  }

  tellSnapshot(snapshot: Snapshot): void {
    for (const { listener } of this.#entries) listener.snapshot(snapshot);
  }

  tellStates(records: readonly CommandRecord[]): void {
    for (const record of records) {
      const event = this.#events.add(record);
      for (const { listener } of this.#entries) listener.state(event);
    }
  }

  /** States may have been lost on the way here: everyone is told of the gap, or looks again. */
  tellMissed(): void {
    this.#events.lose();
    for (const { listener } of this.#entries) listener.missed();
  }

  /** Sends everyone away. */
  close(reason: "over" | "restart"): void {
    for (const { listener } of this.#entries) listener.over(reason);
    this.#entries.clear();
  }

  #add(listener: Listener, key: string | null, door: ReaderDoor): () => boolean {
    if (this.#entries.size >= limits.readersPerRobot) {
      throw new Refusal(
        "too-many-readers",
        `${limits.readersPerRobot} connections read this robot already. End some of them first.`,
        { headers: retryAfter(5000) },
      );
    }
    const entry = { listener, key, door };
    this.#entries.add(entry);
    return () => this.#entries.delete(entry);
  }
}
