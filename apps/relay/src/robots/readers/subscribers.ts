/**
 * Subscribers of one robot: the feeds of connected readers, and requests that wait for an event
 * (long polls). They receive all changes in order.
 */
import type { CommandRecord, Marks, StateEvent } from "@corridor/protocol";
import type { Clock } from "../../platform/time/clock.ts";
import type { WaitLimit } from "../../platform/time/wait-limit.ts";
import { Refusal, retryAfter } from "../../platform/errors/problems.ts";
import type { CarriedSnapshot } from "../../bus/carried-snapshot.ts";
import type { EventLog } from "../../platform/events/event-log.ts";
import { StoreUnavailableError } from "../../platform/errors/store-unavailable.ts";
import { keyRevoked } from "../access/key-ring.ts";
import { limits } from "../../platform/limits/limits.ts";
import { type Caller, scriptIsBlocked } from "../access/callers.ts";

/** A subscriber: a reader's feed or a waiting request. */
interface Listener {
  snapshot(snapshot: CarriedSnapshot): void;
  state(event: StateEvent): void;
  /** the robot's maze has changed */
  maze(version: string): void;
  /** a script has marked cells */
  marks?(marks: Marks): void;
  /** states may have been missed */
  missed(): void;
  over(reason: DismissalReason): void;
}

/**
 * Why the relay ends a subscription. over: the robot was deleted or has expired; restart:
 * the relay stops; revoked: the key was revoked; busy: the relay cannot read which keys are valid;
 * blocked: the owner blocked the script
 */
export type DismissalReason = "over" | "restart" | "revoked" | "busy" | "blocked";

/** Transports of subscriptions. `long-poll` is a single request. */
export const readerTransports = [
  "websocket",
  "long-poll-connection",
  "events",
  "long-poll",
] as const;
export type ReaderTransport = (typeof readerTransports)[number];

/** A wait of a caller: it fails once the caller may no longer read. */
export interface CallerWait extends WaitLimit {
  key?: Caller;
}

export class Subscribers {
  readonly #clock: Clock;
  readonly #events: EventLog<CommandRecord>;
  readonly #entries = new Set<{
    listener: Listener;
    key: Caller | null;
    transport: ReaderTransport;
  }>();

  /** @param events numbers the states, and stores them for readers that reconnect */
  constructor(clock: Clock, events: EventLog<CommandRecord>) {
    this.#clock = clock;
    this.#events = events;
  }

  get isEmpty(): boolean {
    return this.#entries.size === 0;
  }

  count(): Record<ReaderTransport, number> {
    const counts = { websocket: 0, "long-poll-connection": 0, events: 0, "long-poll": 0 };
    for (const { transport } of this.#entries) counts[transport] += 1;
    return counts;
  }

  /**
   * Adds the feed of a connected script or viewer.
   * @returns a function that removes the feed
   * @throws Refusal too-many-readers, for this key or this robot
   */
  join(listener: Listener, key: Caller, transport: ReaderTransport): () => void {
    const ofKey = [...this.#entries].filter(
      (entry) => entry.transport !== "long-poll" && entry.key?.hash === key.hash,
    ).length;
    // Many viewers, such as a class, share one watch key.
    if (key.kind !== "watch" && ofKey >= limits.readersPerKey) {
      throw new Refusal(
        "too-many-readers",
        `${limits.readersPerKey} connections use this key, the maximum. End a script, then try again.`,
        { headers: retryAfter(5000) },
      );
    }
    return this.#add(listener, key, transport);
  }

  /**
   * Waits until the listener calls `done`, the wait times out or is aborted, states may have been
   * missed, or the robot ends.
   * @param listen returns the callbacks, which call `done` to end the wait
   * @throws Refusal too-many-readers, or the reason for which the relay ends the subscription;
   * StoreUnavailableError if the valid keys are unknown
   */
  async until(
    { milliseconds, signal, key }: CallerWait,
    listen: (done: () => void) => Partial<Pick<Listener, "snapshot" | "state">>,
  ): Promise<void> {
    if (milliseconds === 0 || signal.aborted) return;
    const { promise, resolve, reject } = Promise.withResolvers<void>();
    const over = (reason: DismissalReason): void => {
      if (reason === "revoked") return reject(keyRevoked());
      if (reason === "busy") return reject(new StoreUnavailableError("the valid keys are unknown"));
      if (reason === "blocked") return reject(scriptIsBlocked());
      return resolve();
    };
    const ignoring = { snapshot: () => undefined, state: () => undefined, maze: () => undefined };
    const listener = { ...ignoring, ...listen(resolve), missed: resolve, over };
    const leave = this.#add(listener, key ?? null, "long-poll");
    const cancelTimer = this.#clock.after(milliseconds, resolve);
    signal.addEventListener("abort", () => resolve(), { once: true });
    try {
      await promise;
    } finally {
      cancelTimer();
      leave();
    }
  }

  publishSnapshot(snapshot: CarriedSnapshot): void {
    for (const { listener } of this.#entries) listener.snapshot(snapshot);
  }

  publishMaze(version: string): void {
    for (const { listener } of this.#entries) listener.maze(version);
  }

  publishMarks(marks: Marks): void {
    for (const { listener } of this.#entries) listener.marks?.(marks);
  }

  publishStates(records: readonly CommandRecord[]): void {
    for (const record of records) {
      const event = this.#events.add(record);
      for (const { listener } of this.#entries) listener.state(event);
    }
  }

  /** States may have been missed: discards the stored events and notifies all subscribers. */
  publishMissed(): void {
    this.#events.lose();
    for (const { listener } of this.#entries) listener.missed();
  }

  /** Ends the subscriptions of the matching callers. */
  dismiss(isMeant: (caller: Caller) => boolean, reason: DismissalReason): void {
    for (const entry of this.#entries) {
      if (entry.key === null || !isMeant(entry.key)) continue;
      this.#entries.delete(entry);
      entry.listener.over(reason);
    }
  }

  /** Ends all subscriptions. */
  close(reason: "over" | "restart"): void {
    for (const { listener } of this.#entries) listener.over(reason);
    this.#entries.clear();
  }

  #add(listener: Listener, key: Caller | null, transport: ReaderTransport): () => void {
    // Viewers have a separate limit, so that they never exclude a script.
    const isWatcher = key?.kind === "watch";
    const alike = [...this.#entries].filter((entry) => (entry.key?.kind === "watch") === isWatcher);
    if (alike.length >= limits.readersPerRobot) {
      throw new Refusal(
        "too-many-readers",
        `${limits.readersPerRobot} connections read this robot, the maximum. End a script, then try again.`,
        { headers: retryAfter(5000) },
      );
    }
    const entry = { listener, key, transport };
    this.#entries.add(entry);
    return () => void this.#entries.delete(entry);
  }
}
