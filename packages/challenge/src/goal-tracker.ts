/** Tracks tick by tick whether the robot meets the goal of a challenge. */
import { CELL, countOpenCells, isBlock, sizeOf, type MazeDocument } from "@corridor/maze";
import { type RobotReport, TICKS_PER_SECOND } from "@corridor/protocol";
import type { Goal } from "./task-schema.ts";

/** The parts of a robot at the end of a tick that a goal depends on. */
export interface GoalRobot {
  readonly tick: number;
  /** distance driven, in units */
  readonly distance: number;
  /** first tick at whose end the whole robot was inside a goal cell; null before */
  readonly goalTick: number | null;
  report: () => Pick<RobotReport, "sensors">;
}

export class GoalTracker {
  readonly #goal: Goal;
  readonly #visited: Uint8Array;
  readonly #columns: number;
  readonly #rows: number;
  /** number of open cells of the maze */
  readonly open: number;
  #visitedCount = 0;

  /** The robot must be at the maze's start. */
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

  /** Number of open cells that the robot's centre has visited. */
  get visited(): number {
    return this.#visitedCount;
  }

  /** Marks the cell `row * columns + column` as visited. */
  visit(cell: number): void {
    if (this.#visited[cell] !== 0) return;
    this.#visited[cell] = 1;
    this.#visitedCount++;
  }

  /** Marks the cell at a position as visited, in units. Ignores positions outside the maze. */
  visitAt(x: number, y: number): void {
    const column = Math.floor(x / CELL);
    const row = Math.floor(y / CELL);
    const isInside = column >= 0 && row >= 0 && column < this.#columns && row < this.#rows;
    if (isInside) this.visit(row * this.#columns + column);
  }

  /**
   * Whether the goal is met at the end of this tick.
   * @param isStill whether the robot stands still; the single tick between two manoeuvres does not
   *   count
   */
  isMet(robot: GoalRobot, isStill: boolean): boolean {
    const goal = this.#goal;
    switch (goal.kind) {
      case "reach":
        return robot.goalTick !== null;
      case "visit":
        return this.#visitedCount >= this.open;
      case "stop": {
        if (!isStill || robot.distance === 0) return false;
        const reading = robot.report().sensors[goal.sensor];
        return reading >= goal.from && reading <= goal.to;
      }
      case "drive":
        return robot.distance >= goal.distance;
      case "last":
        return robot.tick >= goal.seconds * TICKS_PER_SECOND;
    }
  }
}
