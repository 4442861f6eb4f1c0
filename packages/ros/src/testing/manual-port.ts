/** A port whose robot does what the test says, and timers without a clock. */
import {
  checkCommand,
  hasEnded,
  READ_ONLY,
  RefusedError,
  termsOf,
  type CommandRecord,
  type EventGap,
  type Order,
  type PublishedMaze,
  type RobotListener,
  type RobotPort,
  type Snapshot,
} from "@corridor/protocol";

export class ManualPort implements RobotPort {
  readonly capability: RobotPort["capability"];
  newest: Snapshot | null = null;
  maze: object | null = null;
  /** status of the answer to a request for the maze, if it has one */
  mazeStatus = 200;
  readonly orders: Order[] = [];
  readonly cancelled: number[] = [];
  isClosed = false;
  /** number of calls of `endOf` that have not returned */
  waits = 0;
  readonly #records: CommandRecord[] = [];
  readonly #listeners = new Set<RobotListener>();
  readonly #ends: (() => void)[] = [];

  constructor(capability: RobotPort["capability"] = "drive") {
    this.capability = capability;
  }

  report(snapshot: Snapshot): void {
    this.newest = snapshot;
    for (const listener of this.#listeners) listener.snapshot(snapshot);
  }

  enter(maze: object): void {
    this.maze = maze;
    for (const listener of this.#listeners) listener.maze("A".repeat(22));
  }

  /** Ends a command. */
  end(seq: number, change: Partial<CommandRecord>): void {
    const record = this.#records[seq - 1];
    if (record !== undefined) {
      Object.assign(record, change);
      for (const listener of this.#listeners) listener.state({ ...record });
    }
    for (const resolve of this.#ends.splice(0)) resolve();
  }

  subscribe(listener: RobotListener): () => void {
    this.#listeners.add(listener);
    return () => void this.#listeners.delete(listener);
  }

  async send(order: Order, key?: string): Promise<CommandRecord> {
    if (this.capability === "watch") throw refusal("forbidden", 403, READ_ONLY);
    checkCommand(order, key);
    this.orders.push(order);
    const { command } = termsOf(order);
    const record: CommandRecord = {
      seq: this.orders.length,
      key: key ?? null,
      action: command.action,
      command,
      state: "accepted",
      reason: null,
      acceptedAt: "2026-01-01T12:00:00.000Z",
      pose: null,
      distance: null,
      duplicate: false,
    };
    this.#records.push(record);
    return record;
  }

  /** States were missed. */
  miss(open: EventGap["open"]): void {
    for (const listener of this.#listeners) listener.gap(open);
  }

  async endOf(seq: number): Promise<CommandRecord> {
    const record = this.#records[seq - 1];
    if (record === undefined) throw refusal("no-command", 404, "No command has this number.");
    this.waits += 1;
    while (!hasEnded(record.state)) {
      await new Promise<void>((resolve) => void this.#ends.push(resolve));
    }
    this.waits -= 1;
    return record;
  }

  async cancel(seq: number): Promise<CommandRecord> {
    this.cancelled.push(seq);
    const record = this.#records[seq - 1];
    if (record === undefined) throw refusal("no-command", 404, "No command has this number.");
    return record;
  }

  async readMaze(): Promise<PublishedMaze> {
    if (this.maze === null) throw refusal("no-maze", 404, "The robot has no maze.");
    if (this.mazeStatus !== 200) throw refusal("unavailable", this.mazeStatus, "Try again.");
    return { text: JSON.stringify(this.maze), version: "A".repeat(22) };
  }

  close(): void {
    this.isClosed = true;
  }
}

function refusal(kind: string, status: number, detail: string): RefusedError {
  return new RefusedError({ type: `/problems/${kind}`, title: kind, status, detail, errors: [] });
}
