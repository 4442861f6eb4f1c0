/**
 * Follows one robot tick by tick, whoever drives it, and says when the challenge is met in its maze or can
 * no longer be. What `checkChallenge` says of a program that drives alone, this says of it too, at the
 * same tick.
 */
import type { MazeDocument } from "@corridor/maze";
import type { DriverName, Pose, RobotReport } from "@corridor/protocol";
import { TICKS_PER_SECOND } from "@corridor/simulation";
import type { ChallengeDocument, Goal } from "./challenge-document.ts";
import { GoalWatch } from "./goal-watch.ts";
import type { FailureCode } from "./verdict.ts";

/** As much of a challenge as one robot in one of its mazes is judged by. */
export interface AttemptTerms {
  goal: Goal;
  checks: ChallengeDocument["checks"];
  drivers: readonly DriverName[];
  maze: MazeDocument;
}

/** How an attempt stands; `tick` is the one at whose end that was so. */
export type Judgement =
  | { kind: "open" }
  | { kind: "met"; driver: DriverName; tick: number; bumps: number }
  | { kind: "failed"; code: Extract<FailureCode, "driver" | "bump"> | "late"; tick: number };

/** As much of a robot as a judge looks at. */
export interface JudgedRobot {
  readonly tick: number;
  readonly pose: Pose;
  readonly bumps: number;
  /** units driven so far */
  readonly distance: number;
  /** who drives the next tick */
  readonly driver: DriverName;
  report: () => RobotReport;
}

/** What one maze of a challenge asks. @param index of the maze; a RangeError where there is none */
export function termsOf(
  { goal, checks, allowed, mazes }: ChallengeDocument,
  index: number,
): AttemptTerms {
  const maze = mazes[index];
  if (maze === undefined) throw new RangeError(`The challenge has no maze ${index}.`);
  return { goal, checks, drivers: allowed.drivers, maze };
}

const open: Judgement = { kind: "open" };

export class AttemptJudge {
  readonly #terms: AttemptTerms;
  readonly #watch: GoalWatch;
  #judgement: Judgement = open;
  /** before the tick that runs */
  #pose: Pose | null = null;
  #driver: DriverName = "program";
  /** whether somebody moved the robot who may not */
  #isByStranger = false;
  /** ticks in a row in which nothing moved the robot */
  #standing = 0;

  /** The robot stands at the maze's start. */
  constructor(terms: AttemptTerms) {
    this.#terms = terms;
    this.#watch = new GoalWatch(terms.goal, terms.maze);
  }

  /** Once met or failed it stays so. */
  get judgement(): Judgement {
    return this.#judgement;
  }

  /** A tick is about to run. */
  before(robot: JudgedRobot): void {
    if (this.#judgement !== open) return;
    this.#pose = robot.pose;
    this.#driver = robot.driver;
    if (this.#terms.goal.kind !== "stop") return;
    this.#standing = robot.report().motion === "stop" ? this.#standing + 1 : 0;
  }

  /** The tick has run. */
  after(robot: JudgedRobot): void {
    const before = this.#pose;
    if (this.#judgement !== open || before === null) return;
    const { x, y, heading } = robot.pose;
    this.#watch.visitAt(x, y);
    const hasMoved = x !== before.x || y !== before.y || heading !== before.heading;
    if (hasMoved && !this.#terms.drivers.includes(this.#driver)) this.#isByStranger = true;
    this.#judge(robot, this.#driver, this.#standing > 1);
  }

  /** Time stands still: a hand has let go of the robot, which stays where it is. */
  rest(robot: JudgedRobot): void {
    if (this.#judgement !== open || this.#terms.goal.kind !== "stop") return;
    if (robot.driver !== "me" || robot.report().motion !== "stop") return;
    this.#judge(robot, robot.driver, true);
  }

  #judge(robot: JudgedRobot, driver: DriverName, isStill: boolean): void {
    const { checks } = this.#terms;
    const { tick, bumps, distance } = robot;
    const failed = (code: "driver" | "bump" | "late"): Judgement => ({
      kind: "failed",
      code,
      tick,
    });
    if (checks.bumps !== null && bumps > checks.bumps) this.#judgement = failed("bump");
    else if (tick > checks.seconds * TICKS_PER_SECOND) this.#judgement = failed("late");
    else if (this.#watch.isMet({ ...robot.report(), isStill }, distance)) {
      this.#judgement = this.#isByStranger
        ? failed("driver")
        : { kind: "met", driver, tick, bumps };
    }
  }
}
