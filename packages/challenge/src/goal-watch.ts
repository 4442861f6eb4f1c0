/** Watches for the goal of a challenge while the robot drives, tick by tick. */
import { CELL, countOpenCells, isBlock, sizeOf, type MazeDocument } from "@corridor/maze";
import type { SensorReadings } from "@corridor/protocol";
import { TICKS_PER_SECOND } from "@corridor/simulation";
import type { Goal } from "./challenge-document.ts";

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
  readonly #rows: number;
  readonly open: number;
  #visitedCount = 0;

  /** The robot stands at the maze's start. */
  constructor(goal: Goal, maze: MazeDocument) {
    const { columns, rows } = sizeOf(maze);
    this.#goal = goal;
    this.#columns = columns;
    this.#rows = rows;
    this.#visited = new Uint8Array(columns * rows);
    this.open = countOpenCells(maze);
    const { column, row } = maze.start;
    if (!isBlock(maze, column, row)) this.visit(row * columns + column);
  }

  /** Open cells in which the robot's centre has been. */
  get visited(): number {
    return this.#visitedCount;
  }

  /** The robot's centre is in this cell, counted as `row * columns + column`. */
  visit(cell: number): void {
    if (this.#visited[cell] !== 0) return;
    this.#visited[cell] = 1;
    this.#visitedCount++;
  }

  /** The robot's centre is here, in units; outside of the maze nothing is visited. */
  visitAt(x: number, y: number): void {
    const column = Math.floor(x / CELL);
    const row = Math.floor(y / CELL);
    const isInside = column >= 0 && row >= 0 && column < this.#columns && row < this.#rows;
    if (isInside) this.visit(row * this.#columns + column);
  }

  /** Whether the goal is met at the end of this tick. @param distance units driven so far */
  isMet(moment: GoalMoment, distance: number): boolean {
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
