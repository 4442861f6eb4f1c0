/**
 * A robot's channel to the other relays that hold it: messages, their rate, and the list of these
 * relays. Without other relays it costs next to nothing.
 */
import type { Marks, RecallCause } from "@corridor/protocol";
import type { Clock } from "../../platform/time/clock.ts";
import type { BusListener, Channel, Scripts, CommandChanges, Bus } from "../../bus/bus.ts";
import type { CarriedSnapshot } from "../../bus/carried-snapshot.ts";
import {
  dueAfter,
  type CoalescedTimers,
  type Waiter,
} from "../../platform/time/coalesced-timers.ts";
import { limits } from "../../platform/limits/limits.ts";
import { older, together } from "./merged-scripts.ts";

/** Another relay that holds the robot, as it announced itself. */
interface OtherRelay {
  lastActiveAt: number;
  scripts: Scripts;
}

export class RobotChannel implements Waiter {
  readonly #clock: Clock;
  readonly #timers: CoalescedTimers;
  #channel: Channel | null = null;
  /** by name; they receive snapshots */
  readonly #others = new Map<string, OtherRelay>();
  #announcedAt = -Infinity;
  #pending: CarriedSnapshot | null = null;
  /** no snapshot is published before this time, except one that precedes an ending */
  #notBefore = -Infinity;
  /** whether a timer is pending */
  #isArmed = false;

  constructor(clock: Clock, timers: CoalescedTimers) {
    this.#clock = clock;
    this.#timers = timers;
  }

  async open(bus: Bus, robot: string, listener: BusListener): Promise<void> {
    this.#channel = await bus.join(robot, listener);
  }

  /** See `Channel`. Before the channel is open, nobody reads the robot at this relay. */
  get returnsOwnChanges(): boolean {
    return this.#channel?.returnsOwnChanges ?? true;
  }

  /** Publishes changes by this relay to other relays, for their readers and for the page. */
  commandsChanged(changes: CommandChanges): void {
    this.#channel?.commandsChanged(changes);
  }

  /** @param name identifies the page across its connections */
  pageConnected(epoch: number, name: string): void {
    this.#channel?.notify({ kind: "page", epoch, name });
  }

  pageLeft(epoch: number, closedByPage: boolean): void {
    this.#channel?.notify({ kind: "page-left", epoch, closedByPage });
  }

  /** Asks the page with this epoch, at another relay, to release the robot. */
  yield(epoch: number): void {
    this.#channel?.notify({ kind: "yield", epoch });
  }

  /** Reports that the page with this epoch at this relay has released the robot. */
  yielded(epoch: number): void {
    this.#channel?.notify({ kind: "yielded", epoch });
  }

  /** Asks the page, at another relay, to end a command. */
  cancel(seq: number, cause: RecallCause): void {
    this.#channel?.notify({ kind: "cancel", seq, cause });
  }

  /** Reports that the owner has changed keys or the permissions of scripts. */
  rightsChanged(): void {
    this.#channel?.notify({ kind: "keys" });
  }

  mazeChanged(version: string): void {
    this.#channel?.notify({ kind: "maze", version });
  }

  marked(marks: Marks): void {
    this.#channel?.notify({ kind: "marks", marks });
  }

  deleted(): void {
    this.#channel?.notify({ kind: "over" });
  }

  /**
   * Offers a snapshot to the other relays. It is published now, later, or never if a newer one
   * replaces it.
   */
  snapshot(snapshot: CarriedSnapshot): void {
    // Most robots have no other relay.
    if (this.#others.size === 0 || this.#present.size === 0) return;
    this.#pending = snapshot;
    if (!this.#isArmed) this.#publishDue();
  }

  /**
   * Publishes the pending snapshot, so that readers at other relays receive it before an ending.
   */
  flush(): void {
    this.#send();
    this.#channel?.flush();
  }

  /**
   * Announces to the page's relay that this relay holds the robot, so that it receives snapshots.
   * @param asks whether to request the newest snapshot immediately
   */
  announce(scripts: Scripts, asks = false): void {
    this.#announcedAt = this.#clock.now();
    this.#channel?.notify({ kind: "here", from: "", scripts, asks });
  }

  /** Repeats the announcement at intervals of `limits.relayHereMs`. */
  repeatAnnouncement(scripts: Scripts): void {
    if (this.#clock.now() - this.#announcedAt >= limits.relayHereMs) this.announce(scripts);
  }

  receivedAnnouncement(from: string, scripts: Scripts): void {
    this.#others.set(from, { lastActiveAt: this.#clock.now(), scripts });
  }

  /** Scripts of all relays. The age of each announcement is added to its times. */
  withOthers(own: Scripts): Scripts {
    const all = [...this.#present.values()].map(({ lastActiveAt, scripts }) =>
      older(scripts, this.#clock.now() - lastActiveAt),
    );
    return all.reduce(together, own);
  }

  leave(): void {
    this.#pending = null;
    this.#channel?.leave();
    this.#channel = null;
  }

  /** The other relays, without those that no longer announce themselves. */
  get #present(): ReadonlyMap<string, OtherRelay> {
    const oldest = this.#clock.now() - limits.relaySilenceMs;
    for (const [name, { lastActiveAt }] of this.#others) {
      if (lastActiveAt < oldest) this.#others.delete(name);
    }
    return this.#others;
  }

  wake(): void {
    this.#isArmed = false;
    this.#publishDue();
  }

  #publishDue(): void {
    if (this.#pending === null) return;
    const now = this.#clock.now();
    if (now < this.#notBefore) {
      this.#isArmed = true;
      return this.#timers.wakeAfter(this.#notBefore - now, this);
    }
    this.#notBefore = dueAfter(this.#notBefore, now, limits.snapshotIntervalMs);
    this.#send();
  }

  #send(): void {
    if (this.#pending !== null) this.#channel?.sendSnapshot(this.#pending, this.#present.keys());
    this.#pending = null;
  }
}
