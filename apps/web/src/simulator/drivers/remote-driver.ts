/**
 * Driving by remote commands: they start in the order of their seq. A manoeuvre runs to its end, and
 * a guarded motion until one of its conditions is true. A motion without an end lasts until the next
 * command. A motion whose lease expires is cancelled. Only the robot ends a delivered command, and it ends each exactly once. It measures ttls with its own
 * clock.
 */
import {
  isVelocity,
  type AliveDriver,
  type DeliveredCommand,
  type EndingState,
  type Pose,
} from "@corridor/protocol";
import type { Run, RunInput } from "@corridor/recording";
import { BurstGuard } from "./burst-guard.ts";
import type { CancelReason } from "../protocol/cancel-reason.ts";
import { MotionGuard } from "./motion-guard.ts";
import { MotionLease } from "./motion-lease.ts";

export interface Ending {
  state: EndingState;
  /** null if the robot itself ended it */
  reason: CancelReason | null;
  pose: Pose;
  /** units driven by this command */
  distance: number;
}

export interface RemoteDriverEvents {
  started(seq: number): void;
  ended(seq: number, ending: Ending): void;
  /** All commands delivered so far have ended. */
  swept?(reason: CancelReason): void;
}

/** The driven robot: its state, and where commands go. */
export interface RemoteRobot {
  readonly run: Pick<
    Run,
    | "command"
    | "commandEnding"
    | "distance"
    | "driver"
    | "isInGoal"
    | "isManoeuvring"
    | "pose"
    | "readings"
  >;
  addInput(input: RunInput): boolean;
}

interface Queued {
  delivery: DeliveredCommand;
  /** when it expires, by the clock of `now` */
  startBy: number;
}

interface Running {
  seq: number;
  /** units driven before it */
  distance: number;
  lease: MotionLease | null;
  /** of a guarded motion */
  guard: MotionGuard | null;
}

export class RemoteDriver {
  readonly #events: RemoteDriverEvents;
  readonly #robotNow: () => RemoteRobot;
  readonly #now: () => number;
  readonly #bursts = new BurstGuard();
  #queue: Queued[] = [];
  #running: Running | null = null;

  /**
   * @param robot returns the currently driven robot
   * @param now monotonic milliseconds
   */
  constructor(events: RemoteDriverEvents, robot: () => RemoteRobot, now: () => number) {
    this.#events = events;
    this.#robotNow = robot;
    this.#now = now;
  }

  /** The running command, and the units driven before it. */
  get running(): { seq: number; distance: number } | null {
    if (this.#running === null) return null;
    const { seq, distance } = this.#running;
    return { seq, distance };
  }

  /** Whether the robot has nothing to do until a script sends the next command. */
  get isIdle(): boolean {
    return this.#running === null && this.#queue.length === 0;
  }

  /** Queues a delivered command. One that replaces ends all before it. */
  accept(delivery: DeliveredCommand): void {
    const now = this.#now();
    if (delivery.replace || isReset(delivery)) {
      const isRunning = this.#running !== null;
      this.#endAll("superseded", "replaced");
      // A script that is refused does not stop the robot of the user who drives.
      if (this.#robot.run.driver === "remote")
        this.#robot.addInput(isRunning ? { do: "cancel", superseded: true } : { do: "cancel" });
    }
    if (isVelocity(delivery.command)) {
      this.#bursts.add(now, delivery.ttl - delivery.remaining, Date.parse(delivery.acceptedAt));
      this.#supersedeLast(delivery.driver);
    }
    this.#running?.lease?.renew(delivery.driver, now);
    this.#queue.push({ delivery, startBy: now + delivery.remaining });
  }

  /** Renews the lease of the running motion if its script is alive. */
  renew(alive: readonly AliveDriver[]): void {
    // A lease that expired while the page was frozen is not renewed.
    this.update();
    const now = this.#now();
    for (const { driver, silentMs, connectionMs } of alive) {
      this.#running?.lease?.renew(driver, now - silentMs);
      if (connectionMs !== null) this.#bursts.connect(connectionMs, now);
    }
  }

  /** Ends expired commands, and a motion whose lease has expired. */
  update(): void {
    const now = this.#now();
    if (this.#running?.lease?.isOver(now) === true) this.#stop("silent");
    if (this.#queue.length === 0) return;
    const expired = this.#queue.filter(({ startBy }) => startBy <= now);
    if (expired.length === 0) return;
    this.#queue = this.#queue.filter(({ startBy }) => startBy > now);
    for (const { delivery } of expired) this.#report(delivery.seq, "expired", null, 0);
  }

  /**
   * Between two ticks: resets the robot if that is the next command, which has ended all earlier
   * ones. @param reset moves the robot to its start, which starts a new run
   */
  takeReset(reset: () => void): void {
    const next = this.#queue[0]?.delivery;
    if (next === undefined || !isReset(next)) return;
    this.#queue.shift();
    reset();
    this.#events.started(next.seq);
    this.#report(next.seq, "completed", null, 0);
  }

  /** Before a tick: starts the next command unless a manoeuvre or a guarded motion runs. */
  start(): void {
    const { run } = this.#robot;
    const next = this.#queue[0]?.delivery;
    if (next === undefined || run.isManoeuvring || this.#isGuarded) return;
    // It is not part of the run: see `takeReset`.
    if (next.command.action === "reset") return;
    const now = this.#now();
    if (isVelocity(next.command) && this.#bursts.isHeld(now)) return;
    this.#queue.shift();
    const wasMoving = this.#running !== null;
    this.#end("completed", null);
    const guard = MotionGuard.of(next);
    const { seq } = next;
    this.#running = { seq, distance: run.distance, lease: MotionLease.of(next, now), guard };
    // A motion whose condition is true already does not begin.
    const isOver = guard?.isTrue(run) === true;
    // Recorded runs contain no conditions, but the tick on which the motion was cancelled.
    const { until: _until, ...command } = next.command;
    if (!isOver) this.#robot.addInput({ do: "command", command, seq });
    else if (wasMoving) this.#robot.addInput({ do: "cancel" });
    this.#events.started(seq);
    if (isOver) this.#end("completed", null);
    else this.finish();
  }

  /**
   * After a tick: ends the command whose manoeuvre is complete or that ran into a wall, and the
   * guarded motion of which a condition is true. A collision takes precedence.
   */
  finish(): void {
    const { run } = this.#robot;
    if (this.#running === null) return;
    if (run.command === null) return this.#end(run.commandEnding ?? "completed", null);
    if (this.#running.guard?.isTrue(run) !== true) return;
    this.#end("completed", null);
    this.#robot.addInput({ do: "cancel" });
  }

  /** Ends the running and every queued command; the caller stops the robot. */
  cancel(reason: CancelReason): void {
    this.#endAll("cancelled", reason);
    this.#events.swept?.(reason);
  }

  /** Ends one command, and stops the robot if it is running. */
  cancelOne(seq: number, reason: CancelReason = "cancelledByScript"): void {
    if (this.#running?.seq === seq) return this.#stop(reason);
    const others = this.#queue.filter(({ delivery }) => delivery.seq !== seq);
    if (others.length === this.#queue.length) return;
    this.#queue = others;
    this.#report(seq, "cancelled", reason, 0);
  }

  /**
   * The page has reconnected to the relay: discards queued commands, which the relay delivers
   * again.
   */
  reset(): void {
    this.#queue = [];
    this.#bursts.reconnect();
  }

  get #robot(): RemoteRobot {
    return this.#robotNow();
  }

  /** Whether a guarded motion runs, for whose end the next command waits. */
  get #isGuarded(): boolean {
    return this.#running !== null && this.#running.guard !== null;
  }

  /** Of consecutive velocities of one script in the queue, only the newest counts. */
  #supersedeLast(driver: string): void {
    const last = this.#queue.at(-1)?.delivery;
    if (last === undefined || !isVelocity(last.command) || last.driver !== driver) return;
    this.#queue.pop();
    this.#report(last.seq, "superseded", "replaced", 0);
  }

  #stop(reason: CancelReason): void {
    this.#end("cancelled", reason);
    this.#robot.addInput({ do: "cancel" });
  }

  #endAll(state: EndingState, reason: CancelReason): void {
    this.#end(state, reason);
    const queued = this.#queue;
    this.#queue = [];
    for (const { delivery } of queued) this.#report(delivery.seq, state, reason, 0);
  }

  #end(state: EndingState, reason: CancelReason | null): void {
    const running = this.#running;
    if (running === null) return;
    this.#running = null;
    this.#report(running.seq, state, reason, this.#robot.run.distance - running.distance);
  }

  #report(seq: number, state: EndingState, reason: CancelReason | null, distance: number): void {
    this.#events.ended(seq, { state, reason, pose: this.#robot.run.pose, distance });
  }
}

function isReset({ command }: DeliveredCommand): boolean {
  return command.action === "reset";
}
