/** The robot as topics show it: its newest snapshot, its velocity and its maze. */
import { CELL, readMaze, sizeOf, type MazeDocument } from "@corridor/maze";
import { isTemporary, RefusedError, type RobotPort, type Snapshot } from "@corridor/protocol";
import {
  rosPose,
  stampOf,
  velocityBetween,
  type RosPose,
  type Stamp,
  type Velocity,
} from "./conversions.ts";

/** Snapshots farther apart do not show the velocity. */
const MAX_TICKS = 60;
const STANDING: Velocity = { linear: 0, angular: 0 };

export class RobotView {
  readonly #port: RobotPort;
  #snapshot: Snapshot | null;
  #velocity = STANDING;
  /** undefined: not read yet; null: the robot has none */
  #maze: MazeDocument | null | undefined = undefined;
  /** counts changes of the maze, so that an old one does not replace a newer one */
  #version = 0;

  constructor(port: RobotPort) {
    this.#port = port;
    this.#snapshot = port.newest;
  }

  /** null before the robot's first report */
  get snapshot(): Snapshot | null {
    return this.#snapshot;
  }

  get velocity(): Velocity {
    return this.#velocity;
  }

  get maze(): MazeDocument | null {
    return this.#maze ?? null;
  }

  /** Whether the maze is known, or known to be none. Poses depend on its height. */
  get isReady(): boolean {
    return this.#maze !== undefined;
  }

  /** Simulated time; 0 before the robot's first report. */
  get stamp(): Stamp {
    return stampOf(this.#snapshot?.tick ?? 0);
  }

  poseOf(pose: Snapshot["pose"]): RosPose {
    return rosPose(pose, this.maze === null ? 0 : sizeOf(this.maze).rows * CELL);
  }

  update(snapshot: Snapshot): void {
    const before = this.#snapshot;
    const ticks = snapshot.tick - (before?.tick ?? 0);
    this.#snapshot = snapshot;
    if (ticks === 0 && snapshot.state === "running") return;
    const isClose = before !== null && ticks > 0 && ticks <= MAX_TICKS;
    this.#velocity = isClose ? velocityBetween(before.pose, snapshot.pose, ticks) : STANDING;
  }

  /**
   * Reads the robot's maze. A robot without a maze, or with one of a later version, has none.
   * @throws RefusedError if it cannot be read now
   */
  async readMaze(): Promise<void> {
    this.#version += 1;
    const version = this.#version;
    this.#maze = undefined;
    const maze = await mazeOf(this.#port);
    if (version === this.#version) this.#maze = maze;
  }
}

async function mazeOf(port: RobotPort): Promise<MazeDocument | null> {
  try {
    const maze = readMaze((await port.readMaze()).text);
    return maze.ok ? maze.value : null;
  } catch (error) {
    if (error instanceof RefusedError && !isTemporary(error.problem)) return null;
    throw error;
  }
}
