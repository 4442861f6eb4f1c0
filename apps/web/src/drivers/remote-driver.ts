/**
 * Driving by remote commands: they start in the order of their seq, a manoeuvre runs to its end, and
 * a motion without an end lasts until the next command or until its lease is over. Only the robot ends a
 * command that it was given, and it ends each exactly once. It counts by its own clock how long each may
 * wait.
 */
import type { AliveDriver, DeliveredCommand, EndingState, Pose } from "@corridor/protocol";
import type { Run, RunInput } from "@corridor/recording";
import { BurstGuard } from "./burst-guard.ts";
import type { CancelReason } from "./cancel-reason.ts";
import { isRegister, MotionLease } from "./motion-lease.ts";

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
  /** All that was given so far is over, whatever of it there was. */
  swept?(reason: CancelReason): void;
}

/** The robot that is driven: what it is doing, and where commands go. */
export interface RemoteRobot {
  readonly run: Pick<Run, "command" | "commandEnding" | "distance" | "isManoeuvring" | "pose">;
  addInput(input: RunInput): boolean;
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
  lease: MotionLease | null;
}

export class RemoteDriver {
  readonly #events: RemoteDriverEvents;
  readonly #robotNow: () => RemoteRobot;
  readonly #now: () => number;
  readonly #bursts = new BurstGuard();
  #waiting: Waiting[] = [];
  #running: Running | null = null;

  /**
   * @param robot the one that is driven at the moment
   * @param now monotonic milliseconds
   */
  constructor(events: RemoteDriverEvents, robot: () => RemoteRobot, now: () => number) {
    this.#events = events;
    this.#robotNow = robot;
    this.#now = now;
  }

  /** The command that runs, and the units driven before it. */
  get running(): { seq: number; distance: number } | null {
    if (this.#running === null) return null;
    const { seq, distance } = this.#running;
    return { seq, distance };
  }

  /** Whether the robot has nothing to do until a script sends the next command. */
  get isIdle(): boolean {
    return this.#running === null && this.#waiting.length === 0;
  }

  /** Takes a delivered command into the queue. One that replaces ends all before it. */
  accept(delivery: DeliveredCommand): void {
    const now = this.#now();
    if (delivery.replace) {
      const isRunning = this.#running !== null;
      this.#endAll("superseded", "replaced");
      this.#robot.addInput(isRunning ? { do: "cancel", superseded: true } : { do: "cancel" });
    }
    if (isRegister(delivery)) {
      this.#bursts.came(now, delivery.ttl - delivery.remaining);
      this.#supersedeLast(delivery.driver);
    }
    this.#running?.lease?.heard(delivery.driver, now);
    this.#waiting.push({ delivery, startBy: now + delivery.remaining });
  }

  /** Scripts were heard: who is, keeps the motion that it wished. */
  hear(alive: readonly AliveDriver[]): void {
    // A lease that ran out while the page slept is not renewed any more.
    this.tend();
    const now = this.#now();
    for (const { driver, silentMs, connectionMs } of alive) {
      this.#running?.lease?.heard(driver, now - silentMs);
      if (connectionMs !== null) this.#bursts.lineOf(connectionMs, now);
    }
  }

  /** As time passes: ends what has waited too long, and a motion whose lease is over. */
  tend(): void {
    const now = this.#now();
    if (this.#running?.lease?.isOver(now) === true) this.#stop("silent");
    if (this.#waiting.length === 0) return;
    const late = this.#waiting.filter(({ startBy }) => startBy <= now);
    if (late.length === 0) return;
    this.#waiting = this.#waiting.filter(({ startBy }) => startBy > now);
    for (const { delivery } of late) this.#report(delivery.seq, "expired", null, 0);
  }

  /** Before a tick: starts the next command unless a manoeuvre runs. */
  begin(): void {
    const { run } = this.#robot;
    const next = this.#waiting[0]?.delivery;
    if (next === undefined || run.isManoeuvring) return;
    const now = this.#now();
    if (isRegister(next) && this.#bursts.isHeld(now)) return;
    this.#waiting.shift();
    this.#end("completed", null);
    this.#running = {
      seq: next.seq,
      distance: run.distance,
      lease: MotionLease.of(next, now),
    };
    this.#robot.addInput({ do: "command", command: next.command, seq: next.seq });
    this.#events.started(next.seq);
    this.finish();
  }

  /** After a tick: ends the command whose manoeuvre is over or that ran into a wall. */
  finish(): void {
    const { run } = this.#robot;
    if (this.#running === null || run.command !== null) return;
    this.#end(run.commandEnding ?? "completed", null);
  }

  /** Ends the running and every waiting command; the robot is for the caller to stop. */
  cancel(reason: CancelReason): void {
    this.#endAll("cancelled", reason);
    this.#events.swept?.(reason);
  }

  /** Ends one command that somebody takes back, and stops the robot where it runs. */
  takeBack(seq: number, reason: CancelReason = "takenBack"): void {
    if (this.#running?.seq === seq) return this.#stop(reason);
    const rest = this.#waiting.filter(({ delivery }) => delivery.seq !== seq);
    if (rest.length === this.#waiting.length) return;
    this.#waiting = rest;
    this.#report(seq, "cancelled", reason, 0);
  }

  /** A new line to the relay: forgets what waits, since the relay gives again what still holds. */
  giveBack(): void {
    this.#waiting = [];
    this.#bursts.newLine();
  }

  get #robot(): RemoteRobot {
    return this.#robotNow();
  }

  /** Of the velocities of one script that wait one behind the other, the newest counts. */
  #supersedeLast(driver: string): void {
    const last = this.#waiting.at(-1)?.delivery;
    if (last === undefined || !isRegister(last) || last.driver !== driver) return;
    this.#waiting.pop();
    this.#report(last.seq, "superseded", "replaced", 0);
  }

  #stop(reason: CancelReason): void {
    this.#end("cancelled", reason);
    this.#robot.addInput({ do: "cancel" });
  }

  #endAll(state: EndingState, reason: CancelReason): void {
    this.#end(state, reason);
    const waiting = this.#waiting;
    this.#waiting = [];
    for (const { delivery } of waiting) this.#report(delivery.seq, state, reason, 0);
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
