/**
 * The newest snapshot of one robot, and whether the robot is alive. It is held in memory only,
 * because each snapshot replaces the one before it.
 *
 * Ticks of the simulation prove that the robot is alive. An open connection does not, because a
 * frozen page still answers pings. A connected page counts as paused if it is silent, or if its
 * ticks stop while it reports `running`. A disconnected page counts as gone.
 */
import type { CarriedSnapshot } from "../bus/carried-snapshot.ts";
import { limits } from "../platform/limits/limits.ts";

/** Upper bound for the snapshots that a page sends in a second. */
const MOST_A_SECOND = 100;

export class RobotView {
  #newest: CarriedSnapshot | null = null;
  /** tick of the newest snapshot of this page */
  #tick: number | null = null;
  #lastActiveAt = 0;
  /** lower bound of seq, above all snapshots of previous pages */
  #least = 0;
  #state: "awake" | "asleep" | "gone" = "gone";

  /** The newest snapshot, with the current state; null if the robot has never reported. */
  get newest(): CarriedSnapshot | null {
    return this.#newest;
  }

  /** Whether the robot is neither gone nor paused. */
  get isAwake(): boolean {
    return this.#state === "awake" && this.#newest?.state === "running";
  }

  /**
   * Whether the page is awake and reports that the run waits for its user. A snapshot of another
   * relay may also mean that the page is asleep.
   */
  get isRunPaused(): boolean {
    return this.#state === "awake" && this.#newest?.state === "paused";
  }

  /**
   * Records a snapshot of the page. Its seq always rises, even if the page reloads at another
   * relay.
   */
  report(snapshot: CarriedSnapshot, now: number): void {
    const seq = Math.max(snapshot.seq, (this.#newest?.seq ?? -1) + 1, this.#least);
    const isStill = snapshot.state === "running" && snapshot.tick === this.#tick;
    this.#tick = snapshot.tick;
    this.#newest = seq === snapshot.seq ? snapshot : snapshot.numbered(seq);
    // A repeated tick proves nothing, and does not wake a robot that is asleep.
    if (isStill) return this.#marked();
    this.#lastActiveAt = now;
    this.#state = "awake";
  }

  /** Records a snapshot from the page's relay, which has already set its seq and state. */
  receive(snapshot: CarriedSnapshot): void {
    this.#newest = snapshot;
    this.#state = "awake";
  }

  /** @param ageMs age of the robot if another page owned it before; 0 for its first page */
  pageConnected(now: number, ageMs: number): void {
    // The last seq at a relay that is gone is unknown, but it cannot exceed this.
    this.#least = Math.ceil((ageMs / 1000) * MOST_A_SECOND);
    this.#lastActiveAt = now;
    this.#tick = null;
    if (this.#state === "gone") this.#state = "asleep";
    this.#marked();
  }

  pageLeft(): void {
    this.#state = "gone";
    this.#marked();
  }

  /** @returns true if the page has just been detected as asleep */
  checkAsleep(now: number): boolean {
    if (this.#state !== "awake" || now - this.#lastActiveAt <= limits.asleepMs) return false;
    this.#state = "asleep";
    this.#marked();
    return true;
  }

  /** Marks the stored snapshot of a robot that does not report as gone or paused. */
  #marked(): void {
    if (this.#newest === null || this.#state === "awake") return;
    this.#newest = this.#newest.with({ state: this.#state === "gone" ? "gone" : "paused" });
  }
}
