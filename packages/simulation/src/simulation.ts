/**
 * One robot in one maze, tick by tick. Same maze and same commands at the same ticks: the same
 * snapshots, bit for bit, in every engine.
 *
 * The order inside a tick: the motion controller plans, the heading turns, the physics moves the body
 * as far as it can, the motion controller closes the tick, the sensors read. A command that comes
 * between two ticks counts from the next tick on.
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

/** A robot at a wall is off by rounding. */
const TOUCHING = 1e-6;

export class Simulation {
  readonly #motion = new MotionController();
  readonly #physics: PhysicsWorld;
  readonly #way = new Float64Array(2);
  #maze: MazeDocument;
  #grid: Grid;
  #goals: ReadonlySet<number>;
  #heading: number;
  #distance = 0;
  #goalTick: number | null = null;
  #tick = 0;
  #isStopped = false;
  /** front, right, back, left in units: the order of the protocol's sensor names */
  readonly readings = new Float64Array(4);

  constructor(maze: MazeDocument) {
    this.#maze = maze;
    this.#grid = gridOf(maze);
    this.#goals = goalCells(maze);
    const { x, y, heading } = startPose(maze);
    this.#heading = heading;
    this.#physics = new PhysicsWorld(this.#grid, x, y);
    this.#sense();
  }

  /** Puts the robot at the maze's start, still, with every counter at 0. */
  reset(): void {
    const { x, y, heading } = startPose(this.#maze);
    this.#heading = heading;
    this.#physics.place(x, y);
    this.#motion.begin({ action: "stop" });
    this.#distance = 0;
    this.#goalTick = null;
    this.#tick = 0;
    this.#isStopped = false;
    this.#sense();
  }

  /**
   * Changes the maze around the robot, which stays where it is and goes on with what it does.
   * @returns false where the robot would stand in a block or outside: then nothing has changed
   */
  setMaze(maze: MazeDocument): boolean {
    const grid = gridOf(maze);
    if (!this.#physics.setGrid(grid)) return false;
    this.#maze = maze;
    this.#grid = grid;
    this.#goals = goalCells(maze);
    this.#sense();
    return true;
  }

  /** The robot as it is at the end of this tick. */
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
   * Puts a saved robot back; what follows is what followed then, bit for bit.
   * @param maze the maze that it was saved in
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
    this.#sense();
  }

  /** Begins a command; a motion or manoeuvre that still runs is dropped where it stands. */
  apply(command: Command): void {
    this.#motion.begin(command);
  }

  /** One tick of 1/60 s. */
  step(): void {
    const motion = this.#motion;
    motion.plan(this.#heading);
    const { linear, angular } = motion;
    let isStopped = false;
    if (linear !== 0) {
      // An arc is driven along the direction in its middle.
      if (angular !== 0) this.#face(normaliseHeading(this.#heading + angular / 2));
      isStopped = this.#drive(linear);
    }
    if (angular !== 0) {
      this.#heading = Number.isNaN(motion.exactHeading)
        ? normaliseHeading(this.#heading + angular)
        : motion.exactHeading;
      this.#face(this.#heading);
    }
    motion.finish(isStopped);
    this.#isStopped = isStopped;
    this.#tick++;
    if (linear !== 0 || angular !== 0) this.#readSensors();
    if (this.#goalTick === null && this.#isInGoal()) this.#goalTick = this.#tick;
  }

  /** Ticks since the robot was put at its start. */
  get tick(): number {
    return this.#tick;
  }

  /** Whether an action runs that ends by itself; meanwhile no rule is evaluated. */
  get isManoeuvring(): boolean {
    return this.#motion.isManoeuvring;
  }

  /** Index of the manoeuvre's part that runs, or ran last. */
  get part(): number {
    return this.#motion.part;
  }

  /** How far the manoeuvre is; null when none runs. */
  get progress(): Progress | null {
    return this.#motion.progress;
  }

  /** How the last manoeuvre ended; null while one runs and after any other command. */
  get ending(): MotionEnding | null {
    return this.#motion.ending;
  }

  /** Whether a block stopped the robot in the last tick. */
  get isStopped(): boolean {
    return this.#isStopped;
  }

  /** Contacts with walls so far. */
  get bumps(): number {
    return this.#physics.bumps;
  }

  /** Units driven so far, forward and backward. */
  get distance(): number {
    return this.#distance;
  }

  /** Tick at which the whole robot first stood in a goal cell; null when it has not yet. */
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

  /** What the robot reports at the end of this tick. */
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

  #isInGoal(): boolean {
    if (!this.#goals.has(this.cell)) return false;
    const { x, y } = this.#physics;
    return isWithinCell(x) && isWithinCell(y);
  }

  #drive(linear: number): boolean {
    const physics = this.#physics;
    const fromX = physics.x;
    const fromY = physics.y;
    const isStopped = physics.move((this.#way[0] ?? 0) * linear, (this.#way[1] ?? 0) * linear);
    if (isStopped) {
      const dx = physics.x - fromX;
      const dy = physics.y - fromY;
      this.#distance += Math.sqrt(dx * dx + dy * dy);
    } else {
      this.#distance += Math.abs(linear);
    }
    return isStopped;
  }

  #face(heading: number): void {
    writeUnitVector(heading, this.#way);
  }

  #sense(): void {
    this.#face(this.#heading);
    this.#readSensors();
  }

  #readSensors(): void {
    const grid = this.#grid;
    const { x, y } = this.#physics;
    const wayX = this.#way[0] ?? 0;
    const wayY = this.#way[1] ?? 0;
    const { readings } = this;
    writeRange(grid, x, y, wayX, wayY, readings, 0);
    writeRange(grid, x, y, -wayY, wayX, readings, 1);
    writeRange(grid, x, y, -wayX, -wayY, readings, 2);
    writeRange(grid, x, y, wayY, -wayX, readings, 3);
  }
}

/** Whether a disc around this coordinate lies between the borders of its cell; touching them is fine. */
function isWithinCell(coordinate: number): boolean {
  const fromMiddle = (coordinate % CELL) - CELL / 2;
  return Math.abs(fromMiddle) <= CELL / 2 - ROBOT_RADIUS + TOUCHING;
}

/** Centre of the start cell and the start heading. */
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
