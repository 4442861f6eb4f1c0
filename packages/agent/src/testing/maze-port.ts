/** A port whose robot drives at once, for tests without a relay. */
import {
  checkCommand,
  READ_ONLY,
  RefusedError,
  termsOf,
  type CommandRecord,
  type Order,
  type PublishedMaze,
  type RobotListener,
  type RobotPort,
  type Snapshot,
} from "@corridor/protocol";
import type { MazeRobot } from "./maze-robot.ts";

export class MazePort implements RobotPort {
  readonly capability: RobotPort["capability"];
  readonly robot: MazeRobot;
  newest: Snapshot | null;
  /** false: commands start, and do not end */
  endsCommands = true;
  /** refuses the next requests; null: none */
  refusal: RefusedError | null = null;
  isClosed = false;
  readonly #listeners = new Set<RobotListener>();
  readonly #records: { key: string | null; text: string; record: CommandRecord }[] = [];

  constructor(robot: MazeRobot, capability: RobotPort["capability"] = "drive") {
    this.robot = robot;
    this.capability = capability;
    this.newest = robot.snapshot();
  }

  get subscriptions(): number {
    return this.#listeners.size;
  }

  /** The robot reports. */
  report(change: Partial<Snapshot> = {}): void {
    const snapshot = this.robot.snapshot(change);
    this.newest = snapshot;
    for (const listener of this.#listeners) listener.snapshot(snapshot);
  }

  /** The port may no longer read. */
  end(error: RefusedError): void {
    for (const listener of this.#listeners) listener.end(error);
  }

  subscribe(listener: RobotListener): () => void {
    if (this.refusal !== null) throw this.refusal;
    this.#listeners.add(listener);
    return () => void this.#listeners.delete(listener);
  }

  async send(order: Order, key?: string): Promise<CommandRecord> {
    if (this.refusal !== null) throw this.refusal;
    if (this.capability === "watch") throw refusal("forbidden", 403, READ_ONLY);
    checkCommand(order, key);
    const { command } = termsOf(order);
    const text = JSON.stringify(command);
    const stored = this.#records.find((each) => key !== undefined && each.key === key);
    if (stored !== undefined) {
      if (stored.text !== text) throw refusal("key-conflict", 409, "The key was used.");
      return { ...stored.record, duplicate: true };
    }
    const { state, distance } = this.robot.execute(command);
    const record: CommandRecord = {
      seq: this.#records.length + 1,
      key: key ?? null,
      action: command.action,
      command,
      state: this.endsCommands ? state : "started",
      reason: null,
      acceptedAt: "2026-01-01T12:00:00.000Z",
      pose: this.endsCommands ? this.robot.pose : null,
      distance: this.endsCommands ? distance : null,
      duplicate: false,
    };
    this.#records.push({ key: key ?? null, text, record });
    this.report();
    return record;
  }

  async endOf(seq: number): Promise<CommandRecord> {
    if (this.refusal !== null) throw this.refusal;
    const found = this.#records[seq - 1];
    if (found === undefined) throw refusal("no-command", 404, "No command has this number.");
    return found.record;
  }

  async cancel(seq: number): Promise<CommandRecord> {
    return this.endOf(seq);
  }

  async readMaze(): Promise<PublishedMaze> {
    if (this.refusal !== null) throw this.refusal;
    return { text: JSON.stringify(this.robot.maze), version: "A".repeat(22) };
  }

  close(): void {
    this.isClosed = true;
  }
}

export function refusal(kind: string, status: number, detail: string): RefusedError {
  return new RefusedError({ type: `/problems/${kind}`, title: kind, status, detail, errors: [] });
}
