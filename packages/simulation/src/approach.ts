/**
 * Records the cause of a bump: the decision that led to it, and the free distance when the motion,
 * or the part of the manoeuvre, started. The bump card displays it. It does not affect the
 * simulation.
 */
import type { Command, SensorReadings } from "@corridor/protocol";
import type { Progress } from "./motion/progress.ts";
import type { Simulation } from "./simulation.ts";

/**
 * Cause of a bump: the robot's action, its free distance and its needed distance. Lengths in units.
 */
export interface BumpCause {
  /** tick at whose end the decision or command for this motion was made */
  decidedAt: number;
  /**
   * tick at whose end the part, or the steady motion, started; repeated decisions do not change it
   */
  startedAt: number;
  action: Command["action"];
  /** sensor readings at the end of `decidedAt` */
  readings: SensorReadings;
  /**
   * index of the manoeuvre's part that hit the wall, and number of parts; 0 and 1 without a
   * manoeuvre
   */
  part: number;
  parts: number;
  /** side of the robot in the driving direction */
  side: "front" | "back";
  /** reading of that side's sensor at the end of `startedAt`, from the robot's centre */
  reading: number;
  /** distance driven since `startedAt` */
  driven: number;
  /** planned distance of the part; null for a motion without an end */
  needed: number | null;
}

/** Serialisable state of an `Approach`. */
export interface ApproachState {
  decidedAt: number;
  command: Command;
  readings: Float64Array;
  progress: Progress | null;
  startedAt: number;
  front: number;
  back: number;
  distance: number;
}

export class Approach {
  #decidedAt = 0;
  #command: Command = { action: "stop" };
  /** front, right, back, left at the time of the decision */
  readonly #readings = new Float64Array(4);
  /** progress at the start of the current part; null for a motion without an end */
  #progress: Progress | null = null;
  /** values at the start of the current part or steady motion */
  #startedAt = 0;
  #front = 0;
  #back = 0;
  #distance = 0;

  /** Tick at whose end the last decision or command was made. */
  get decidedAt(): number {
    return this.#decidedAt;
  }

  /** The last decision or command. */
  get command(): Command {
    return this.#command;
  }

  /** Records a decision or command at the end of this tick. */
  recordDecision(simulation: Simulation, command: Command): void {
    const isSameMotion =
      !simulation.isManoeuvring && command.action === this.#command.action && !isWheels(command);
    this.#decidedAt = simulation.tick;
    this.#command = command;
    this.#readings.set(simulation.readings);
    if (!isSameMotion) this.#startPart(simulation);
  }

  /** Records the start of the next part of a manoeuvre. Call it after each tick. */
  update(simulation: Simulation): void {
    if (this.#progress === null || simulation.part === this.#progress.part) return;
    if (simulation.isManoeuvring) this.#startPart(simulation);
  }

  /** Returns the cause of a bump in the last tick. Call it before `update`. */
  cause(simulation: Simulation): BumpCause {
    const [front = 0, right = 0, back = 0, left = 0] = this.#readings;
    const progress = this.#progress;
    const side = isBackward(this.#command) ? "back" : "front";
    return {
      decidedAt: this.#decidedAt,
      startedAt: this.#startedAt,
      action: this.#command.action,
      readings: { front, right, back, left },
      part: progress?.part ?? 0,
      parts: progress?.parts ?? 1,
      side,
      reading: side === "back" ? this.#back : this.#front,
      driven: simulation.distance - this.#distance,
      needed: progress?.kind === "drive" ? progress.of : null,
    };
  }

  save(): ApproachState {
    return {
      decidedAt: this.#decidedAt,
      command: this.#command,
      readings: this.#readings.slice(),
      progress: this.#progress,
      startedAt: this.#startedAt,
      front: this.#front,
      back: this.#back,
      distance: this.#distance,
    };
  }

  restore(state: ApproachState): void {
    this.#decidedAt = state.decidedAt;
    this.#command = state.command;
    this.#readings.set(state.readings);
    this.#progress = state.progress;
    this.#startedAt = state.startedAt;
    this.#front = state.front;
    this.#back = state.back;
    this.#distance = state.distance;
  }

  #startPart(simulation: Simulation): void {
    this.#progress = simulation.progress;
    this.#startedAt = simulation.tick;
    this.#front = simulation.readings[0] ?? 0;
    this.#back = simulation.readings[2] ?? 0;
    this.#distance = simulation.distance;
  }
}

function isWheels(command: Command): boolean {
  return command.action === "drive";
}

function isBackward(command: Command): boolean {
  if (command.action === "move") return command.distance < 0;
  if (command.action === "drive") return command.left + command.right < 0;
  return command.action === "reverse";
}
