/**
 * Everyone who follows one robot at this moment: the feeds of scripts that are connected, and requests
 * that wait for something to happen (long polls). They hear every change in the order in which it came.
 */
import type { CommandRecord, StateEvent } from "@corridor/protocol";
import type { Clock } from "../clock.ts";
import { Refusal, retryAfter } from "../problems.ts";
import type { CarriedSnapshot } from "./carried-snapshot.ts";
import type { EventLog } from "./event-log.ts";
import { StoreAway } from "../store/store-away.ts";
import { keyRevoked } from "./key-ring.ts";
import { limits } from "./limits.ts";
import type { Caller } from "./script.ts";
import { scriptIsAway } from "./script-gate.ts";

/** Whoever follows the robot: a reader's feed, or a request that waits. */
interface Listener {
  snapshot(snapshot: CarriedSnapshot): void;
  state(event: StateEvent): void;
  /** the robot is in another maze */
  maze(version: string): void;
  /** states may have been lost on the way here */
  missed(): void;
  over(reason: AwayReason): void;
}

/**
 * Why somebody is sent away. revoked: the key was, by which they read; busy: nobody knows whether it was;
 * blocked: the owner wants them to go
 */
export type AwayReason = "over" | "restart" | "revoked" | "busy" | "blocked";

/** The ways in which a robot is followed. */
export type ReaderDoor = "websocket" | "line" | "events" | "long-poll";

/** How long somebody waits, and what makes them stop earlier. */
export interface Patience {
  milliseconds: number;
  signal: AbortSignal;
  /** by which key they read; who waits is sent away when it is revoked */
  key?: Caller;
}

export class Audience {
  readonly #clock: Clock;
  readonly #events: EventLog;
  readonly #entries = new Set<{ listener: Listener; key: Caller | null; door: ReaderDoor }>();

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
   * Adds the feed of a connected script or watcher.
   * @returns a function that lets it go; false from it: it was gone already
   * @throws Refusal when too many read already, with this key or at this robot
   */
  join(listener: Listener, key: Caller, door: ReaderDoor): () => boolean {
    const ofKey = [...this.#entries].filter(
      (entry) => entry.door !== "long-poll" && entry.key?.hash === key.hash,
    ).length;
    // One watch key is for many: a class looks on.
    if (key.kind !== "watch" && ofKey >= limits.readersPerKey) {
      throw new Refusal(
        "too-many-readers",
        `${limits.readersPerKey} connections use this key, the maximum. End a script, then try again.`,
        { headers: retryAfter(5000) },
      );
    }
    return this.#add(listener, key, door);
  }

  /**
   * Waits until `done` is called, until patience ends or until the session does.
   * @param listen what to listen for; calls `done` when it came
   * @throws Refusal when too many read already, or when they are sent away meanwhile
   */
  async until(
    { milliseconds, signal, key }: Patience,
    listen: (done: () => void) => Partial<Pick<Listener, "snapshot" | "state">>,
  ): Promise<void> {
    if (milliseconds === 0 || signal.aborted) return;
    const { promise, resolve, reject } = Promise.withResolvers<void>();
    const over = (reason: AwayReason): void => {
      if (reason === "revoked") return reject(keyRevoked());
      if (reason === "busy") return reject(new StoreAway("the valid keys are unknown"));
      if (reason === "blocked") return reject(scriptIsAway());
      return resolve();
    };
    const deaf = { snapshot: () => undefined, state: () => undefined, maze: () => undefined };
    const listener = { ...deaf, ...listen(resolve), missed: resolve, over };
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

  tellSnapshot(snapshot: CarriedSnapshot): void {
    for (const { listener } of this.#entries) listener.snapshot(snapshot);
  }

  tellMaze(version: string): void {
    for (const { listener } of this.#entries) listener.maze(version);
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

  /** Sends those away whom it means. */
  dismiss(isMeant: (caller: Caller) => boolean, reason: AwayReason): void {
    for (const entry of this.#entries) {
      if (entry.key === null || !isMeant(entry.key)) continue;
      this.#entries.delete(entry);
      entry.listener.over(reason);
    }
  }

  /** Sends everyone away. */
  close(reason: "over" | "restart"): void {
    for (const { listener } of this.#entries) listener.over(reason);
    this.#entries.clear();
  }

  #add(listener: Listener, key: Caller | null, door: ReaderDoor): () => boolean {
    // Watchers are counted by themselves, so that they never keep a script out.
    const isWatcher = key?.kind === "watch";
    const alike = [...this.#entries].filter((entry) => (entry.key?.kind === "watch") === isWatcher);
    if (alike.length >= limits.readersPerRobot) {
      throw new Refusal(
        "too-many-readers",
        `${limits.readersPerRobot} connections read this robot, the maximum. End a script, then try again.`,
        { headers: retryAfter(5000) },
      );
    }
    const entry = { listener, key, door };
    this.#entries.add(entry);
    return () => this.#entries.delete(entry);
  }
}
