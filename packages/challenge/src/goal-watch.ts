/**
 * Watches for the goal of a challenge while the robot drives, tick by tick in a check or frame by
 * frame in the page.
 */
import { CELL, countOpenCells, isBlock, sizeOf, type MazeDocument } from "@corridor/maze";
import type { SensorReadings } from "@corridor/protocol";
import { TICKS_PER_SECOND } from "@corridor/simulation";
import type { Goal } from "./challenge-document.ts";

/** A way between two moments is looked at in steps of so many units: none leaps over a cell. */
const STEP = 10;

/** What a goal may depend on at the end of a tick. */
export interface GoalMoment {
  tick: number;
  sensors: SensorReadings;
  /** whether the robot stands and stays: between two manoeuvres it stands for a tick as well */
  isStill: boolean;
  goalReached: boolean;
}

export class GoalWatch {
  readonly #goal: Goal;
  readonly #visited: Uint8Array;
  readonly #columns: number;
  readonly open: number;
  #visitedCount = 0;
  #distance = 0;

  /** The robot stands at the maze's start. */
  constructor(goal: Goal, maze: MazeDocument) {
    const { columns, rows } = sizeOf(maze);
    this.#goal = goal;
    this.#columns = columns;
    this.#visited = new Uint8Array(columns * rows);
    this.open = countOpenCells(maze);
    const { column, row } = maze.start;
    if (!isBlock(maze, column, row)) this.visit(row * columns + column);
  }

  /** Open cells in which the robot's centre has been. */
  get visited(): number {
    return this.#visitedCount;
  }

  /** Units driven, as far as they were passed here. */
  get distance(): number {
    return this.#distance;
  }

  /** The robot's centre is in this cell, counted as `row * columns + column`. */
  visit(cell: number): void {
    if (this.#visited[cell] !== 0) return;
    this.#visited[cell] = 1;
    this.#visitedCount++;
  }

  /** The robot's centre went straight from one place to another, in units. */
  pass(fromX: number, fromY: number, toX: number, toY: number): void {
    const dx = toX - fromX;
    const dy = toY - fromY;
    const length = Math.sqrt(dx * dx + dy * dy);
    this.#distance += length;
    const steps = Math.max(1, Math.ceil(length / STEP));
    for (let step = 1; step <= steps; step++) {
      const column = Math.floor((fromX + (dx * step) / steps) / CELL);
      const row = Math.floor((fromY + (dy * step) / steps) / CELL);
      this.visit(row * this.#columns + column);
    }
  }

  /**
   * Whether the goal is met at the end of this tick.
   * @param distance units driven so far, where they were not passed here
   */
  isMet(moment: GoalMoment, distance: number = this.#distance): boolean {
    const goal = this.#goal;
    switch (goal.kind) {
      case "reach":
        return moment.goalReached;
      case "visit":
        return this.#visitedCount >= this.open;
      case "stop": {
        const reading = moment.sensors[goal.sensor];
        const isThere = reading >= goal.from && reading <= goal.to;
        return isThere && moment.isStill && distance > 0;
      }
      case "drive":
        return distance >= goal.distance;
      case "last":
        return moment.tick >= goal.seconds * TICKS_PER_SECOND;
    }
  }
}
