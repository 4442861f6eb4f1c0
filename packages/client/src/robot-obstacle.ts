import type { Obstacle, Snapshot } from "@corridor/protocol";

/** Finds in the snapshots of a robot why it does not continue. */
export class RobotObstacle {
  #current: Obstacle | null = null;
  #newestSeq: number | null = null;

  /** null if the robot continues, and before the first snapshot */
  get current(): Obstacle | null {
    return this.#current;
  }

  read(snapshot: Snapshot): void {
    this.#current = this.#obstacleIn(snapshot);
    this.#newestSeq = Math.max(this.#newestSeq ?? 0, snapshot.seq);
  }

  #obstacleIn({ seq, state }: Snapshot): Obstacle | null {
    if (state === "running") return null;
    if (state === "gone") return "absent";
    // The page reports that it is paused; the relay repeats the last snapshot of one that is asleep.
    const isReported = this.#newestSeq !== null && seq > this.#newestSeq;
    return isReported || this.#current === "paused" ? "paused" : "asleep";
  }
}
