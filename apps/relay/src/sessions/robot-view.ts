/**
 * The newest snapshot of one robot, and whether the robot lives. Kept in memory only: a snapshot is
 * worth nothing once there is a newer one.
 *
 * Life is proved by ticks of the simulation, not by an open connection: a frozen page still answers
 * pings. A page that is connected and silent, or whose ticks stand still while it says that it runs,
 * counts as paused; a page that is away as gone.
 */
import type { CarriedSnapshot } from "./carried-snapshot.ts";
import { limits } from "./limits.ts";

/** More snapshots than any page sends. */
const MOST_A_SECOND = 100;

export class RobotView {
  #newest: CarriedSnapshot | null = null;
  /** of the newest snapshot of this page */
  #tick: number | null = null;
  #heardAt = 0;
  /** a robot had no snapshot with this number before its page came */
  #least = 0;
  #state: "awake" | "asleep" | "away" = "away";

  /** The newest snapshot, with the state as it is now; null while the robot has never reported. */
  get newest(): CarriedSnapshot | null {
    return this.#newest;
  }

  /** Whether the robot is neither gone nor paused. */
  get isAwake(): boolean {
    return this.#state === "awake" && this.#newest?.state === "running";
  }

  /** Takes a snapshot from the page. Its number always rises, also after a reload of the page at another relay. */
  report(snapshot: CarriedSnapshot, now: number): void {
    const seq = Math.max(snapshot.seq, (this.#newest?.seq ?? -1) + 1, this.#least);
    const isStill = snapshot.state === "running" && snapshot.tick === this.#tick;
    this.#tick = snapshot.tick;
    this.#newest = seq === snapshot.seq ? snapshot : snapshot.numbered(seq);
    // A second look at the same tick proves nothing, and does not wake a robot that was found asleep.
    if (isStill) return this.#marked();
    this.#heardAt = now;
    this.#state = "awake";
  }

  /** Takes a snapshot as the page's relay tells it, which has seen to its number and its state. */
  hear(snapshot: CarriedSnapshot): void {
    this.#newest = snapshot;
    this.#state = "awake";
  }

  /** @param ageMs of the robot, where another page had it before; 0 for its first page */
  pageCame(now: number, ageMs: number): void {
    // What was told at a relay that is gone nobody knows, but it cannot have been more than this.
    this.#least = Math.ceil((ageMs / 1000) * MOST_A_SECOND);
    this.#heardAt = now;
    this.#tick = null;
    if (this.#state === "away") this.#state = "asleep";
    this.#marked();
  }

  pageLeft(): void {
    this.#state = "away";
    this.#marked();
  }

  /** @returns true when the page has just been found asleep */
  checkAsleep(now: number): boolean {
    if (this.#state !== "awake" || now - this.#heardAt <= limits.asleepMs) return false;
    this.#state = "asleep";
    this.#marked();
    return true;
  }

  /** What is kept of a robot that does not report says so. */
  #marked(): void {
    if (this.#newest === null || this.#state === "awake") return;
    this.#newest = this.#newest.with({ state: this.#state === "away" ? "gone" : "paused" });
  }
}
