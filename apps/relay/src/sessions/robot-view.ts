/**
 * The newest snapshot of one robot, and whether the robot lives. Kept in memory only: a snapshot is
 * worth nothing once there is a newer one.
 *
 * Life is proved by ticks of the simulation, not by an open connection: a frozen page still answers
 * pings. A page that is connected and silent, or whose ticks stand still while it says that it runs,
 * counts as paused; a page that is away as gone.
 */
import type { Snapshot } from "@corridor/protocol";
import { limits } from "./limits.ts";

export class RobotView {
  #newest: Snapshot | null = null;
  /** of the newest snapshot of this page */
  #tick: number | null = null;
  #heardAt = 0;
  #state: "awake" | "asleep" | "away" = "away";

  /** The newest snapshot, with the state as it is now; null while the robot has never reported. */
  get newest(): Snapshot | null {
    if (this.#newest === null || this.#state === "awake") return this.#newest;
    return { ...this.#newest, state: this.#state === "away" ? "gone" : "paused" };
  }

  /** Takes a snapshot from the page. Its number always rises, also after a reload of the page. */
  report(snapshot: Snapshot, now: number): void {
    const seq = Math.max(snapshot.seq, (this.#newest?.seq ?? -1) + 1);
    const isStill = snapshot.state === "running" && snapshot.tick === this.#tick;
    this.#tick = snapshot.tick;
    this.#newest = seq === snapshot.seq ? snapshot : { ...snapshot, seq };
    // A second look at the same tick proves nothing, and does not wake a robot that was found asleep.
    if (isStill) return;
    this.#heardAt = now;
    this.#state = "awake";
  }

  /** Takes a snapshot as the page's relay tells it, which has seen to its number and its state. */
  hear(snapshot: Snapshot): void {
    this.#newest = snapshot;
    this.#state = "awake";
  }

  pageCame(now: number): void {
    this.#heardAt = now;
    this.#tick = null;
    if (this.#state === "away") this.#state = "asleep";
  }

  pageLeft(): void {
    this.#state = "away";
  }

  /** @returns true when the page has just been found asleep */
  checkAsleep(now: number): boolean {
    if (this.#state !== "awake" || now - this.#heardAt <= limits.asleepMs) return false;
    this.#state = "asleep";
    return true;
  }
}
