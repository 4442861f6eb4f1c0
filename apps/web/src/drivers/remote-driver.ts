/**
 * Driving by remote commands: they start in the order of their seq, a manoeuvre runs to its end, and
 * a motion without an end lasts until the next command. Only the robot ends a command that it was
 * given, and it ends each exactly once. It counts by its own clock how long each may wait.
 */
import type { DeliveredCommand, EndingState, Pose } from "@corridor/protocol";
import type { Run, RunInput } from "@corridor/recording";
import type { CancelReason } from "./cancel-reason.ts";

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

interface Waiting {
  delivery: DeliveredCommand;
  /** when it is too old to start, by the clock of `now` */
  startBy: number;
}

interface Running {
  seq: number;
  /** units driven before it */
  distance: number;
}

export class RemoteDriver {
  readonly #events: RemoteDriverEvents;
  #waiting: Waiting[] = [];
  #running: Running | null = null;

  constructor(events: RemoteDriverEvents) {
    this.#events = events;
  }

  /**
   * Takes a delivered command into the queue. One that replaces ends all before it.
   * @param now monotonic milliseconds, here and below
   */
  accept(robot: RemoteRobot, delivery: DeliveredCommand, now: number): void {
    if (delivery.replace) {
      this.#endAll(robot, "superseded", "replaced");
      robot.input({ do: "cancel" });
    }
    this.#waiting.push({ delivery, startBy: now + delivery.remaining });
  }

  /** Ends what has waited for longer than its sender wished. */
  expire(robot: RemoteRobot, now: number): void {
    if (this.#waiting.length === 0) return;
    const late = this.#waiting.filter(({ startBy }) => startBy <= now);
    if (late.length === 0) return;
    this.#waiting = this.#waiting.filter(({ startBy }) => startBy > now);
    for (const { delivery } of late) this.#report(robot, delivery.seq, "expired", null, 0);
  }

  /** Before a tick: starts the next command unless a manoeuvre runs. */
  begin(robot: RemoteRobot): void {
    const { run } = robot;
    const next = this.#waiting[0]?.delivery;
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
    this.#endAll(robot, "cancelled", reason);
  }

  /** Ends one command that its sender takes back, and stops the robot where it runs. */
  takeBack(robot: RemoteRobot, seq: number): void {
    if (this.#running?.seq === seq) {
      this.#end(robot, "cancelled", "takenBack");
      robot.input({ do: "cancel" });
      return;
    }
    const rest = this.#waiting.filter(({ delivery }) => delivery.seq !== seq);
    if (rest.length === this.#waiting.length) return;
    this.#waiting = rest;
    this.#report(robot, seq, "cancelled", "takenBack", 0);
  }

  /** Forgets what waits: the relay gives again what still holds. */
  giveBack(): void {
    this.#waiting = [];
  }

  #endAll(robot: RemoteRobot, state: EndingState, reason: CancelReason): void {
    this.#end(robot, state, reason);
    const waiting = this.#waiting;
    this.#waiting = [];
    for (const { delivery } of waiting) this.#report(robot, delivery.seq, state, reason, 0);
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
