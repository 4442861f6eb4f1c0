/**
 * Simulates one robot in one maze, tick by tick. The same maze and the same commands at the same
 * ticks produce the same snapshots, bit for bit, in every JavaScript engine.
 *
 * Order of steps in a tick: the motion controller plans, the heading turns, the physics moves the
 * body until it touches a block, the motion controller ends the tick, the sensors measure. A
 * command between two ticks applies from the next tick on.
 */
import { normaliseHeading, writeUnitVector } from "@corridor/geometry";
import { CELL, gridOf, headingNames, type Grid, type MazeDocument } from "@corridor/maze";
import type { Command, Pose, RobotReport } from "@corridor/protocol";
import { MotionController, type MotionEnding } from "./motion/motion-controller.ts";
import type { Progress } from "./motion/progress.ts";
import { PhysicsWorld } from "./physics/physics-world.ts";
import { ROBOT_RADIUS } from "./settings.ts";
import type { SimulationState } from "./simulation-state.ts";
import { writeRange } from "./sensors/range-sensor.ts";

/** Tolerance for rounding errors when the robot touches a wall, in units. */
const CONTACT_EPSILON = 1e-6;

export class Simulation {
  readonly #motion = new MotionController();
  readonly #physics: PhysicsWorld;
  readonly #direction = new Float64Array(2);
  #maze: MazeDocument;
  #grid: Grid;
  #goals: ReadonlySet<number>;
  #heading: number;
  #distance = 0;
  #goalTick: number | null = null;
  #tick = 0;
  #isStopped = false;
  /** front, right, back, left in units, in the order of the protocol's sensor names */
  readonly readings = new Float64Array(4);

  constructor(maze: MazeDocument) {
    this.#maze = maze;
    this.#grid = gridOf(maze);
    this.#goals = goalCells(maze);
    const { x, y, heading } = startPose(maze);
    this.#heading = heading;
    this.#physics = new PhysicsWorld(this.#grid, x, y);
    this.#updateSensors();
  }

  /** Moves the robot to the maze's start, stops it, and resets all counters to 0. */
  reset(): void {
    const { x, y, heading } = startPose(this.#maze);
    this.#heading = heading;
    this.#physics.place(x, y);
    this.#motion.start({ action: "stop" });
    this.#distance = 0;
    this.#goalTick = null;
    this.#tick = 0;
    this.#isStopped = false;
    this.#updateSensors();
  }

  /**
   * Replaces the maze. The robot keeps its position and continues its motion.
   * @returns false, without any change, if the robot would overlap a block or be outside the maze
   */
  setMaze(maze: MazeDocument): boolean {
    const grid = gridOf(maze);
    if (!this.#physics.setGrid(grid)) return false;
    this.#maze = maze;
    this.#grid = grid;
    this.#goals = goalCells(maze);
    this.#updateSensors();
    return true;
  }

  /** Returns the state at the end of this tick. */
  save(): SimulationState {
    return {
      physics: this.#physics.save(),
      motion: this.#motion.save(),
      heading: this.#heading,
      distance: this.#distance,
      goalTick: this.#goalTick,
      tick: this.#tick,
      isStopped: this.#isStopped,
    };
  }

  /**
   * Restores a saved state. The simulation continues bit for bit as it did after `save`.
   * @param maze the maze at the time of `save`
   */
  restore(state: SimulationState, maze: MazeDocument = this.#maze): void {
    if (maze !== this.#maze) {
      this.#maze = maze;
      this.#grid = gridOf(maze);
      this.#goals = goalCells(maze);
    }
    this.#physics.restore(state.physics, this.#grid);
    this.#motion.restore(state.motion);
    this.#heading = state.heading;
    this.#distance = state.distance;
    this.#goalTick = state.goalTick;
    this.#tick = state.tick;
    this.#isStopped = state.isStopped;
    this.#updateSensors();
  }

  /** Starts a command. Cancels a running motion or manoeuvre at its current position. */
  apply(command: Command): void {
    this.#motion.start(command);
  }

  /** Runs one tick of 1/60 s. */
  step(): void {
    const motion = this.#motion;
    motion.plan(this.#heading);
    const { linear, angular } = motion;
    let isStopped = false;
    if (linear !== 0) {
      // Approximates an arc by its chord: the direction at its middle.
      if (angular !== 0) this.#updateDirection(normaliseHeading(this.#heading + angular / 2));
      isStopped = this.#drive(linear);
    }
    if (angular !== 0) {
      this.#heading = Number.isNaN(motion.exactHeading)
        ? normaliseHeading(this.#heading + angular)
        : motion.exactHeading;
      this.#updateDirection(this.#heading);
    }
    motion.finish(isStopped);
    this.#isStopped = isStopped;
    this.#tick++;
    if (linear !== 0 || angular !== 0) this.#readSensors();
    if (this.#goalTick === null && this.isInGoal) this.#goalTick = this.#tick;
  }

  /** Number of ticks since the robot was at its start. */
  get tick(): number {
    return this.#tick;
  }

  /** Whether a running action ends by itself. No rule is evaluated until then. */
  get isManoeuvring(): boolean {
    return this.#motion.isManoeuvring;
  }

  /** Index of the manoeuvre's current or last part. */
  get part(): number {
    return this.#motion.part;
  }

  /** Progress of the running manoeuvre, or null. */
  get progress(): Progress | null {
    return this.#motion.progress;
  }

  /** Ending of the last manoeuvre; null while one runs and after any other command. */
  get ending(): MotionEnding | null {
    return this.#motion.ending;
  }

  /** Whether a block stopped the robot in the last tick. */
  get isStopped(): boolean {
    return this.#isStopped;
  }

  /** Number of contacts with walls since the start. */
  get bumps(): number {
    return this.#physics.bumps;
  }

  /** Distance driven since the start, forward and backward, in units. */
  get distance(): number {
    return this.#distance;
  }

  /** First tick at whose end the whole robot was inside a goal cell; null before. */
  get goalTick(): number | null {
    return this.#goalTick;
  }

  /** The cell under the robot's centre, as `row * columns + column`. */
  get cell(): number {
    const { x, y } = this.#physics;
    return ((y / CELL) | 0) * this.#grid.columns + ((x / CELL) | 0);
  }

  /** The robot's centre, in units. */
  get x(): number {
    return this.#physics.x;
  }

  get y(): number {
    return this.#physics.y;
  }

  get pose(): Pose {
    return { x: this.#physics.x, y: this.#physics.y, heading: this.#heading };
  }

  /** Returns the robot's report at the end of this tick. */
  report(): RobotReport {
    const { readings } = this;
    return {
      tick: this.#tick,
      sensors: {
        front: readings[0] ?? 0,
        right: readings[1] ?? 0,
        back: readings[2] ?? 0,
        left: readings[3] ?? 0,
      },
      pose: this.pose,
      motion: this.#motion.action,
      bumps: this.#physics.bumps,
      bumping: this.#physics.inContact,
      goalReached: this.#goalTick !== null,
    };
  }

  /** Whether the whole robot is inside a goal cell. */
  get isInGoal(): boolean {
    if (!this.#goals.has(this.cell)) return false;
    const { x, y } = this.#physics;
    return isWithinCell(x) && isWithinCell(y);
  }

  #drive(linear: number): boolean {
    const physics = this.#physics;
    const fromX = physics.x;
    const fromY = physics.y;
    const isStopped = physics.move(
      (this.#direction[0] ?? 0) * linear,
      (this.#direction[1] ?? 0) * linear,
    );
    if (isStopped) {
      const dx = physics.x - fromX;
      const dy = physics.y - fromY;
      this.#distance += Math.sqrt(dx * dx + dy * dy);
    } else {
      this.#distance += Math.abs(linear);
    }
    return isStopped;
  }

  #updateDirection(heading: number): void {
    writeUnitVector(heading, this.#direction);
  }

  #updateSensors(): void {
    this.#updateDirection(this.#heading);
    this.#readSensors();
  }

  #readSensors(): void {
    const grid = this.#grid;
    const { x, y } = this.#physics;
    const directionX = this.#direction[0] ?? 0;
    const directionY = this.#direction[1] ?? 0;
    const { readings } = this;
    writeRange(grid, x, y, directionX, directionY, readings, 0);
    writeRange(grid, x, y, -directionY, directionX, readings, 1);
    writeRange(grid, x, y, -directionX, -directionY, readings, 2);
    writeRange(grid, x, y, directionY, -directionX, readings, 3);
  }
}

/** Whether a disc at this coordinate is between the borders of its cell. It may touch them. */
function isWithinCell(coordinate: number): boolean {
  const fromMiddle = (coordinate % CELL) - CELL / 2;
  return Math.abs(fromMiddle) <= CELL / 2 - ROBOT_RADIUS + CONTACT_EPSILON;
}

/** The pose at the centre of the start cell with the start heading. */
function startPose({ start }: MazeDocument): Pose {
  return {
    x: start.column * CELL + CELL / 2,
    y: start.row * CELL + CELL / 2,
    heading: headingNames.indexOf(start.heading) * 90,
  };
}

function goalCells(maze: MazeDocument): ReadonlySet<number> {
  const columns = maze.blocks[0]?.length ?? 0;
  return new Set(maze.goals.map(({ column, row }) => row * columns + column));
}
