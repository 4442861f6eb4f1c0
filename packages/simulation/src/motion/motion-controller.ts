/**
 * Converts a command to linear and angular speeds for each tick, until the command ends.
 *
 * A command is a sequence of parts: drive a distance, turn by an angle, or hold wheel speeds. A
 * contact ends the current part, and the next part starts.
 * Speeds are in units per tick and degrees per tick. This class contains no physics.
 */
import { normaliseHeading } from "@corridor/geometry";
import { TICKS_PER_SECOND, type Command } from "@corridor/protocol";
import {
  DELAY_DISTANCE,
  DRIVE_STEP,
  LEAVE_DISTANCE,
  TICK_SECONDS,
  TRACK_WIDTH,
  TURN_STEP,
  WHEEL_SPEED,
} from "../settings.ts";
import type { Progress } from "./progress.ts";

/**
 * Drives `left` more units, turns by `left` more degrees, or holds wheel speeds for `left` more
 * ticks.
 */
export interface Part {
  kind: "drive" | "turn" | "wheels";
  /** remaining amount; Infinity for a motion without an end */
  left: number;
  /** total amount: `left` at the start of the part */
  of: number;
  /** units per tick along the heading, negative backward */
  linear: number;
  /** degrees per tick, clockwise positive */
  angular: number;
}

/** Ending of a manoeuvre. */
export type MotionEnding = "completed" | "collided";

/** State of the motion at the end of a tick. */
export interface MotionState {
  parts: Part[];
  next: number;
  action: Command["action"];
  isManoeuvre: boolean;
  collided: boolean;
  /** heading at the end of the running turn; NaN before the turn starts */
  target: number;
  ending: MotionEnding | null;
}

/** Rounding error of a distance. A smaller remainder counts as 0. */
const EPSILON = 1e-9;
const DEGREES_PER_RADIAN = 57.29577951308232;

export class MotionController {
  #parts: Part[] = [];
  #next = 0;
  #action: Command["action"] = "stop";
  #isManoeuvre = false;
  #collided = false;
  #target = Number.NaN;
  /** motion of this tick: units along the heading, and degrees */
  linear = 0;
  angular = 0;
  /** exact heading at the end of this tick if a turn ends in it, else NaN */
  exactHeading = Number.NaN;
  /** ending of the last manoeuvre; null while one runs and before the first */
  ending: MotionEnding | null = null;

  /** The running action, or "stop". */
  get action(): Command["action"] {
    return this.#action;
  }

  /** Whether a running action ends by itself. */
  get isManoeuvring(): boolean {
    return this.#isManoeuvre;
  }

  /** Index of the current part; 0 if the motion has no parts. */
  get part(): number {
    return this.#next;
  }

  /** Progress of the running manoeuvre, or null. */
  get progress(): Progress | null {
    const part = this.#parts[this.#next];
    if (part === undefined || !this.#isManoeuvre) return null;
    const { kind, left, of } = part;
    const direction = (kind === "turn" ? part.angular : part.linear) < 0 ? -1 : 1;
    const parts = this.#parts.length;
    return { action: this.#action, part: this.#next, parts, kind, direction, left, of };
  }

  save(): MotionState {
    return {
      parts: this.#parts.map((part) => ({ ...part })),
      next: this.#next,
      action: this.#action,
      isManoeuvre: this.#isManoeuvre,
      collided: this.#collided,
      target: this.#target,
      ending: this.ending,
    };
  }

  restore(state: MotionState): void {
    this.#parts = state.parts.map((part) => ({ ...part }));
    this.#next = state.next;
    this.#action = state.action;
    this.#isManoeuvre = state.isManoeuvre;
    this.#collided = state.collided;
    this.#target = state.target;
    this.ending = state.ending;
  }

  /** Starts a command. Cancels the previous one at its current position. */
  start(command: Command): void {
    if (command.action === this.#action && isSteady(command.action)) return;
    this.#parts = partsOf(command);
    this.#next = 0;
    this.#target = Number.NaN;
    this.#collided = false;
    this.ending = null;
    this.#isManoeuvre = this.#parts.length > 0 && this.#parts.every(({ left }) => left < Infinity);
    this.#action = this.#parts.length > 0 ? command.action : "stop";
    if (this.#parts.length === 0 && command.action !== "stop") this.ending = "completed";
  }

  /** Sets `linear`, `angular` and `exactHeading` for this tick. */
  plan(heading: number): void {
    this.linear = 0;
    this.angular = 0;
    this.exactHeading = Number.NaN;
    const part = this.#parts[this.#next];
    if (part === undefined) return;
    if (part.kind === "wheels") {
      this.linear = part.linear;
      this.angular = part.angular;
    } else if (part.kind === "drive") {
      const step = Math.min(Math.abs(part.linear), part.left);
      this.linear = part.linear < 0 ? -step : step;
    } else {
      if (Number.isNaN(this.#target)) {
        this.#target = normaliseHeading(heading + (part.angular < 0 ? -part.left : part.left));
      }
      const step = Math.min(Math.abs(part.angular), part.left);
      this.angular = part.angular < 0 ? -step : step;
      if (part.left - step <= EPSILON) this.exactHeading = this.#target;
    }
  }

  /**
   * Ends the tick: reduces the remaining amount, and continues with the next part if it is 0.
   * @param isStopped whether a block stopped the robot
   */
  finish(isStopped: boolean): void {
    const part = this.#parts[this.#next];
    if (part === undefined) return;
    if (isStopped) this.#collided = true;
    part.left -=
      part.kind === "wheels" ? 1 : Math.abs(part.kind === "turn" ? this.angular : this.linear);
    const isOver =
      part.left <= EPSILON || (isStopped && part.kind === "drive" && this.#isManoeuvre);
    if (!isOver) return;
    this.#next++;
    this.#target = Number.NaN;
    if (this.#next < this.#parts.length) return;
    this.#isManoeuvre = false;
    this.#action = "stop";
    this.#parts = [];
    this.ending = this.#collided ? "collided" : "completed";
  }
}

/** Whether repeating a command continues the same motion. */
function isSteady(action: Command["action"]): boolean {
  return action === "forward" || action === "reverse" || action === "stop";
}

function drive(distance: number): Part {
  return {
    kind: "drive",
    left: Math.abs(distance),
    of: Math.abs(distance),
    linear: distance < 0 ? -DRIVE_STEP : DRIVE_STEP,
    angular: 0,
  };
}

function turn(degrees: number): Part {
  return {
    kind: "turn",
    left: Math.abs(degrees),
    of: Math.abs(degrees),
    linear: 0,
    angular: degrees < 0 ? -TURN_STEP : TURN_STEP,
  };
}

/**
 * Differential drive: the mean of the rim speeds is the linear speed, and their difference divided
 * by the track width is the angular speed.
 * @see Siegwart, Nourbakhsh, Scaramuzza: Introduction to Autonomous Mobile Robots, ch. 3
 */
function wheels(left: number, right: number, milliseconds: number | undefined): Part {
  const ticks =
    milliseconds === undefined
      ? Infinity
      : Math.max(1, Math.round((milliseconds * TICKS_PER_SECOND) / 1000));
  return {
    kind: "wheels",
    left: ticks,
    of: ticks,
    linear: ((left + right) / 2) * WHEEL_SPEED * TICK_SECONDS,
    angular: (((left - right) * WHEEL_SPEED) / TRACK_WIDTH) * DEGREES_PER_RADIAN * TICK_SECONDS,
  };
}

function partsOf(command: Command): Part[] {
  switch (command.action) {
    case "forward":
      return [drive(Infinity)];
    case "reverse":
      return [drive(-Infinity)];
    case "stop":
      return [];
    case "left 90":
      return [turn(-90)];
    case "right 90":
      return [turn(90)];
    case "turn 180":
      return [turn(180)];
    case "delayed left 90":
      return [drive(DELAY_DISTANCE), turn(-90), drive(LEAVE_DISTANCE)];
    case "delayed right 90":
      return [drive(DELAY_DISTANCE), turn(90), drive(LEAVE_DISTANCE)];
    case "move":
      return command.distance === 0 ? [] : [drive(command.distance)];
    case "turn":
      return command.degrees === 0 ? [] : [turn(command.degrees)];
    case "drive":
      return [wheels(command.left, command.right, command.milliseconds)];
  }
}
