/**
 * Whoever sends a robot commands, one after the other: by the client library, or by requests of its
 * own.
 */
import type { CommandRecord, Order } from "@corridor/protocol";
import { machineNow } from "../clock.ts";
import type { Robot } from "../robots/robot.ts";

let scripts = 0;

/** What is known of a script's commands; the robot's history is told all of it. */
export class Diary {
  readonly #robot: Robot;
  readonly #sender: string;
  /** by key, when it was asked for; until the answer */
  readonly #open = new Map<string, number>();
  readonly #postedAt = new Map<string, number>();
  posted = 0;
  acknowledged = 0;
  /** refused for good: not stored, and never done */
  refused = 0;

  /** @param kind of script, for who reads of a fault */
  constructor(robot: Robot, kind: string) {
    this.#robot = robot;
    this.#sender = `${kind} script ${(scripts += 1)}`;
  }

  /** commands without an answer so far */
  get unanswered(): number {
    return this.#open.size;
  }

  /** When a command was asked for, by its key. */
  postedAt(key: string | null): number | undefined {
    return key === null ? undefined : this.#postedAt.get(key);
  }

  asked(key: string): void {
    const now = machineNow();
    this.posted += 1;
    this.#open.set(key, now);
    this.#postedAt.set(key, now);
  }

  /** @param isTimed the message says when it is sent */
  tries(key: string, ttl: number, isTimed = false): void {
    this.#robot.history.tried(key, { sender: this.#sender, at: machineNow(), ttl, isTimed });
  }

  isAnswered(record: CommandRecord): void {
    this.#robot.history.acknowledged(record);
    if (record.key !== null && this.#open.delete(record.key)) this.acknowledged += 1;
  }

  isTold(record: CommandRecord): void {
    this.#robot.history.told(record);
  }

  /** A newer velocity was sent in its place. */
  isPassedOver(key: string): void {
    this.#open.delete(key);
  }

  isRefused(key: string): void {
    if (this.#open.delete(key)) this.refused += 1;
  }
}

export interface Script {
  readonly diary: Diary;
  /** when it was welcomed, or answered, last; by `machineNow` */
  readonly heardAt: number;
  /** Sends a command, and goes on sending it until it is answered. */
  post(order: Order): void;
  close(): void;
}
