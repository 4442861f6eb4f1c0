/**
 * What the robot was about when it met a wall: the decision that led there, and the room that there was
 * when the motion, or the part of the manoeuvre, began. Read by the bump card; changes nothing.
 */
import type { Command, SensorReadings } from "@corridor/protocol";
import type { Progress } from "./motion/progress.ts";
import type { Simulation } from "./simulation.ts";

/** How it came to a bump: what the robot was doing, the room it had and the room it needed. Lengths in units. */
export interface BumpCause {
  /** tick at whose end the decision or command came that led into the wall */
  decidedAt: number;
  /** tick at whose end the part of the manoeuvre, or the steady motion, began, whichever lines repeated it */
  begunAt: number;
  action: Command["action"];
  /** what the sensors measured at the end of `decidedAt` */
  readings: SensorReadings;
  /** part of the manoeuvre that met the wall, from 0, and how many it has; 0 of 1 where it is none */
  part: number;
  parts: number;
  /** which way the robot drove */
  side: "front" | "back";
  /** what the sensor on that side measured when the part, or the steady motion, began; from the robot's centre */
  reading: number;
  /** driven since then */
  driven: number;
  /** what the part had to drive; null for a motion that lasts until something else is chosen */
  needed: number | null;
}

/** An approach as plain data. */
export interface ApproachState {
  decidedAt: number;
  command: Command;
  readings: Float64Array;
  progress: Progress | null;
  begunAt: number;
  front: number;
  back: number;
  distance: number;
}

export class Approach {
  #decidedAt = 0;
  #command: Command = { action: "stop" };
  /** front, right, back, left at the decision */
  readonly #readings = new Float64Array(4);
  /** of the part that runs, as it began; null for a motion without an end */
  #progress: Progress | null = null;
  /** as the part or the steady motion began */
  #begunAt = 0;
  #front = 0;
  #back = 0;
  #distance = 0;

  /** Tick at whose end the last decision or command came. */
  get decidedAt(): number {
    return this.#decidedAt;
  }

  /** What was decided or commanded last. */
  get command(): Command {
    return this.#command;
  }

  /** A decision or command at the end of this tick. */
  decided(simulation: Simulation, command: Command): void {
    const isSameMotion =
      !simulation.isManoeuvring && command.action === this.#command.action && !isWheels(command);
    this.#decidedAt = simulation.tick;
    this.#command = command;
    this.#readings.set(simulation.readings);
    if (!isSameMotion) this.#begin(simulation);
  }

  /** After each tick: notes where the next part of a manoeuvre begins. */
  follow(simulation: Simulation): void {
    if (this.#progress === null || simulation.part === this.#progress.part) return;
    if (simulation.isManoeuvring) this.#begin(simulation);
  }

  /** How it came to the bump of the tick that has just run; to be asked before `follow`. */
  cause(simulation: Simulation): BumpCause {
    const [front = 0, right = 0, back = 0, left = 0] = this.#readings;
    const progress = this.#progress;
    const side = isBackward(this.#command) ? "back" : "front";
    return {
      decidedAt: this.#decidedAt,
      begunAt: this.#begunAt,
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
      begunAt: this.#begunAt,
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
    this.#begunAt = state.begunAt;
    this.#front = state.front;
    this.#back = state.back;
    this.#distance = state.distance;
  }

  #begin(simulation: Simulation): void {
    this.#progress = simulation.progress;
    this.#begunAt = simulation.tick;
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
