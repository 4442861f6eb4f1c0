/** A script that sends commands to a robot, by the client library or by its own requests. */
import type { CommandRecord, Order } from "@corridor/protocol";
import { machineNow } from "../clock.ts";
import type { Robot } from "../robots/robot.ts";

let scripts = 0;

/** Records the commands of a script, and reports them to the robot's history. */
export class CommandLog {
  readonly #robot: Robot;
  readonly #sender: string;
  /** request times of unanswered commands by key */
  readonly #open = new Map<string, number>();
  readonly #postedAt = new Map<string, number>();
  posted = 0;
  acknowledged = 0;
  /** commands that the relay rejected permanently, which neither are stored nor run */
  rejected = 0;

  /** @param kind of script, for error messages */
  constructor(robot: Robot, kind: string) {
    this.#robot = robot;
    this.#sender = `${kind} script ${(scripts += 1)}`;
  }

  /** number of commands without an answer */
  get unanswered(): number {
    return this.#open.size;
  }

  /** The time at which a command was requested, by its key. */
  postedAt(key: string | null): number | undefined {
    return key === null ? undefined : this.#postedAt.get(key);
  }

  recordRequest(key: string): void {
    const now = machineNow();
    this.posted += 1;
    this.#open.set(key, now);
    this.#postedAt.set(key, now);
  }

  /** @param isTimed whether the message contains its sending time */
  recordAttempt(key: string, ttl: number, isTimed = false): void {
    this.#robot.history.tried(key, { sender: this.#sender, at: machineNow(), ttl, isTimed });
  }

  recordAck(record: CommandRecord): void {
    this.#robot.history.acknowledged(record);
    if (record.key !== null && this.#open.delete(record.key)) this.acknowledged += 1;
  }

  recordState(record: CommandRecord): void {
    this.#robot.history.reported(record);
  }

  /** Records that a newer velocity was sent in place of this one. */
  recordSuperseded(key: string): void {
    this.#open.delete(key);
  }

  recordRejection(key: string): void {
    if (this.#open.delete(key)) this.rejected += 1;
  }
}

export interface Script {
  readonly commands: CommandLog;
  /** time of its last welcome or answer, by `machineNow` */
  readonly lastResponseAt: number;
  /** Sends a command, and repeats it until it is answered. */
  post(order: Order): void;
  close(): void;
}
