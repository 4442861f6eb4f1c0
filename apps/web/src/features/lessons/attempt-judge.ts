/**
 * Follows the run on the screen and says when the challenge is met in the maze that is shown, or can no
 * longer be: from the snapshots that the panels show, from the robot's start on.
 */
import { GoalWatch, type ChallengeDocument, type FailureCode } from "@corridor/challenge";
import type { DriverName, Snapshot } from "@corridor/protocol";
import { TICKS_PER_SECOND } from "@corridor/simulation";

export type Judgement =
  | { kind: "open" }
  | { kind: "met"; driver: DriverName; tick: number; bumps: number }
  | { kind: "failed"; code: Extract<FailureCode, "driver" | "bump"> | "late"; tick: number };

const open: Judgement = { kind: "open" };

export class AttemptJudge {
  readonly #challenge: ChallengeDocument;
  readonly #maze: number;
  #watch: GoalWatch;
  #before: Snapshot | null = null;
  #stranger = false;
  #judgement: Judgement = open;

  /** @param maze index of the maze that is shown */
  constructor(challenge: ChallengeDocument, maze: number) {
    this.#challenge = challenge;
    this.#maze = maze;
    this.#watch = this.#newWatch();
  }

  /** How it stands after this snapshot; once met or failed it stays so until the robot starts again. */
  see(snapshot: Snapshot): Judgement {
    const before = this.#before;
    if (before === null || snapshot.tick < before.tick) this.#begin();
    this.#before = snapshot;
    if (before !== null && snapshot.tick >= before.tick) this.#follow(before, snapshot);
    if (this.#judgement.kind === "open" && snapshot.tick > 0) this.#judge(snapshot);
    return this.#judgement;
  }

  #begin(): void {
    this.#watch = this.#newWatch();
    this.#stranger = false;
    this.#judgement = open;
  }

  #newWatch(): GoalWatch {
    const maze = this.#challenge.mazes[this.#maze];
    if (maze === undefined) throw new RangeError(`The challenge has no maze ${this.#maze}.`);
    return new GoalWatch(this.#challenge.goal, maze);
  }

  #follow(before: Snapshot, { pose, driver }: Snapshot): void {
    const { x, y, heading } = before.pose;
    if (pose.x === x && pose.y === y && pose.heading === heading) return;
    this.#watch.pass(x, y, pose.x, pose.y);
    if (!this.#challenge.allowed.drivers.includes(driver)) this.#stranger = true;
  }

  #judge(snapshot: Snapshot): void {
    const { tick, bumps, driver } = snapshot;
    const { checks } = this.#challenge;
    const failed = (code: "driver" | "bump" | "late"): Judgement => ({
      kind: "failed",
      code,
      tick,
    });
    // Time stands still when a hand lets go.
    const isStill = snapshot.motion === "stop" && snapshot.state === "paused";
    if (checks.bumps !== null && bumps > checks.bumps) this.#judgement = failed("bump");
    else if (this.#watch.isMet({ ...snapshot, isStill })) {
      this.#judgement = this.#stranger ? failed("driver") : { kind: "met", driver, tick, bumps };
    } else if (tick > checks.seconds * TICKS_PER_SECOND) this.#judgement = failed("late");
  }
}
