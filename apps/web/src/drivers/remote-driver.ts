/**
 * Driving by remote commands: they start in the order of their seq, a manoeuvre runs to its end, and
 * a motion without an end lasts until the next command. Only the robot ends a command that it was
 * given, and it ends each exactly once.
 */
import type { Command, EndingState, Pose } from "@corridor/protocol";
import type { Run, RunInput } from "@corridor/recording";
import type { CancelReason } from "./cancel-reason.ts";

export interface Delivery {
  seq: number;
  command: Command;
  /** ISO 8601, by the relay's clock */
  acceptedAt: string;
  /** the sender's idempotency key */
  key: string | null;
}

export interface Ending {
  state: EndingState;
  /** null where the robot itself ended it */
  reason: CancelReason | null;
  pose: Pose;
  /** units driven by this command */
  distance: number;
}

export interface RemoteDriverEvents {
  started(seq: number): void;
  ended(seq: number, ending: Ending): void;
}

/** The robot that is driven: what it is doing, and where commands go. */
export interface RemoteRobot {
  readonly run: Pick<Run, "command" | "commandEnding" | "distance" | "isManoeuvring" | "pose">;
  input(input: RunInput): boolean;
}

interface Running {
  seq: number;
  /** units driven before it */
  distance: number;
}

export class RemoteDriver {
  readonly #events: RemoteDriverEvents;
  #waiting: Delivery[] = [];
  #running: Running | null = null;

  constructor(events: RemoteDriverEvents) {
    this.#events = events;
  }

  /** Takes a delivered command into the queue. */
  accept(delivery: Delivery): void {
    this.#waiting.push(delivery);
  }

  /** Before a tick: starts the next command unless a manoeuvre runs. */
  begin(robot: RemoteRobot): void {
    const { run } = robot;
    const next = this.#waiting[0];
    if (next === undefined || run.isManoeuvring) return;
    this.#waiting.shift();
    this.#end(robot, "completed", null);
    this.#running = { seq: next.seq, distance: run.distance };
    robot.input({ do: "command", command: next.command, seq: next.seq });
    this.#events.started(next.seq);
    this.finish(robot);
  }

  /** After a tick: ends the command whose manoeuvre is over or that ran into a wall. */
  finish(robot: RemoteRobot): void {
    if (this.#running === null || robot.run.command !== null) return;
    this.#end(robot, robot.run.commandEnding ?? "completed", null);
  }

  /** Ends the running and every waiting command; the robot is for the caller to stop. */
  cancel(robot: RemoteRobot, reason: CancelReason): void {
    this.#end(robot, "cancelled", reason);
    const waiting = this.#waiting;
    this.#waiting = [];
    for (const { seq } of waiting) this.#report(robot, seq, "cancelled", reason, 0);
  }

  #end(robot: RemoteRobot, state: EndingState, reason: CancelReason | null): void {
    const running = this.#running;
    if (running === null) return;
    this.#running = null;
    this.#report(robot, running.seq, state, reason, robot.run.distance - running.distance);
  }

  #report(
    robot: RemoteRobot,
    seq: number,
    state: EndingState,
    reason: CancelReason | null,
    distance: number,
  ): void {
    this.#events.ended(seq, { state, reason, pose: robot.run.pose, distance });
  }
}
