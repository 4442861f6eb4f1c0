/**
 * Judges one robot tick by tick, for any driver: whether the challenge is met in its maze, or has
 * failed. For a program that drives alone, the result and its tick equal those of `checkChallenge`.
 */
import type { MazeDocument } from "@corridor/maze";
import { type DriverName, type Pose, type RobotReport, TICKS_PER_SECOND } from "@corridor/protocol";
import { GoalTracker, type GoalRobot } from "./goal-tracker.ts";
import type { Goal, Task } from "./task-schema.ts";
import type { FailureCode } from "./verdict.ts";

/** The parts of a challenge that apply to one robot in one of its mazes. */
export interface AttemptTerms {
  goal: Goal;
  checks: Task["checks"];
  drivers: readonly DriverName[];
  maze: MazeDocument;
}

/** State of an attempt. `tick` is the tick at whose end it was decided. */
export type Judgement =
  | { kind: "open" }
  | { kind: "met"; driver: DriverName; tick: number; bumps: number }
  | { kind: "failed"; code: Extract<FailureCode, "driver" | "bump"> | "late"; tick: number };

/** The interface of a robot that a judge requires. */
export interface JudgedRobot extends GoalRobot {
  readonly pose: Pose;
  readonly bumps: number;
  /** driver of the next tick */
  readonly driver: DriverName;
  report: () => RobotReport;
}

/**
 * Returns the terms of one maze.
 * @throws RangeError if the challenge has no maze with this index
 */
export function termsOf({ goal, checks, allowed, mazes }: Task, index: number): AttemptTerms {
  const maze = mazes[index];
  if (maze === undefined) throw new RangeError(`The challenge has no maze ${index}.`);
  return { goal, checks, drivers: allowed.drivers, maze };
}

const open: Judgement = { kind: "open" };

export class AttemptJudge {
  readonly #terms: AttemptTerms;
  readonly #tracker: GoalTracker;
  #judgement: Judgement = open;
  /** pose before the current tick */
  #pose: Pose | null = null;
  #driver: DriverName = "program";
  /** whether a driver moved the robot that the challenge does not allow */
  #movedByDisallowedDriver = false;
  /** number of consecutive ticks without motion */
  #stillTicks = 0;

  /** The robot must be at the maze's start. */
  constructor(terms: AttemptTerms) {
    this.#terms = terms;
    this.#tracker = new GoalTracker(terms.goal, terms.maze);
  }

  /** The current judgement. It does not change after "met" or "failed". */
  get judgement(): Judgement {
    return this.#judgement;
  }

  /** Call it before each tick. */
  before(robot: JudgedRobot): void {
    if (this.#judgement !== open) return;
    this.#pose = robot.pose;
    this.#driver = robot.driver;
    if (this.#terms.goal.kind !== "stop") return;
    this.#stillTicks = robot.report().motion === "stop" ? this.#stillTicks + 1 : 0;
  }

  /** Call it after each tick. */
  after(robot: JudgedRobot): void {
    const before = this.#pose;
    if (this.#judgement !== open || before === null) return;
    const { x, y, heading } = robot.pose;
    this.#tracker.visitAt(x, y);
    const hasMoved = x !== before.x || y !== before.y || heading !== before.heading;
    if (hasMoved && !this.#terms.drivers.includes(this.#driver))
      this.#movedByDisallowedDriver = true;
    this.#judge(robot, this.#driver, this.#stillTicks > 1);
  }

  /** Call it when simulated time stops after manual control ends and the robot stands still. */
  rest(robot: JudgedRobot): void {
    if (this.#judgement !== open || this.#terms.goal.kind !== "stop") return;
    if (robot.driver !== "me" || robot.report().motion !== "stop") return;
    this.#judge(robot, robot.driver, true);
  }

  #judge(robot: JudgedRobot, driver: DriverName, isStill: boolean): void {
    const { checks } = this.#terms;
    const { tick, bumps } = robot;
    const failed = (code: "driver" | "bump" | "late"): Judgement => ({
      kind: "failed",
      code,
      tick,
    });
    if (checks.bumps !== null && bumps > checks.bumps) this.#judgement = failed("bump");
    else if (tick > checks.seconds * TICKS_PER_SECOND) this.#judgement = failed("late");
    else if (this.#tracker.isMet(robot, isStill)) {
      this.#judgement = this.#movedByDisallowedDriver
        ? failed("driver")
        : { kind: "met", driver, tick, bumps };
    }
  }
}
