/** A port whose robot is the simulation, which executes each command at once. */
import type { MazeDocument } from "@corridor/maze";
import {
  checkCommand,
  RefusedError,
  termsOf,
  type CommandRecord,
  type EndingState,
  type Order,
  type PublishedMaze,
  type RemoteCommand,
  type RobotListener,
  type RobotPort,
  type Snapshot,
} from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { Simulation } from "@corridor/simulation";

export class SimulatedPort implements RobotPort {
  readonly capability = "drive";
  readonly simulation: Simulation;
  readonly orders: Order[] = [];
  newest: Snapshot | null;
  /** the next commands do not reach the robot: they end so */
  readonly endings: { state: EndingState; reason: string }[] = [];
  /** the next requests are refused */
  readonly refusals: RefusedError[] = [];
  isClosed = false;
  readonly #maze: MazeDocument;
  readonly #records: CommandRecord[] = [];
  readonly #listeners = new Set<RobotListener>();
  #seq = 0;
  /** Called before each command. */
  onCommand: (command: RemoteCommand) => void = () => undefined;

  constructor(maze: MazeDocument) {
    this.#maze = maze;
    this.simulation = new Simulation(maze);
    this.newest = this.#snapshot();
  }

  /** Reports the robot's newest tick. */
  report(): void {
    this.newest = this.#snapshot();
    for (const listener of this.#listeners) listener.snapshot(this.newest);
  }

  /** The page's Reset. */
  reset(): void {
    this.simulation.reset();
    this.report();
  }

  end(error: RefusedError): void {
    for (const listener of this.#listeners) listener.end(error);
  }

  subscribe(listener: RobotListener): () => void {
    this.#listeners.add(listener);
    return () => void this.#listeners.delete(listener);
  }

  async send(order: Order): Promise<CommandRecord> {
    const refused = this.refusals.shift();
    if (refused !== undefined) throw refused;
    checkCommand(order, undefined);
    this.orders.push(order);
    const { command } = termsOf(order);
    this.onCommand(command);
    const { state, reason } = this.endings.shift() ?? {
      state: this.#execute(command),
      reason: null,
    };
    this.report();
    const record: CommandRecord = {
      seq: this.#records.length + 1,
      key: null,
      action: command.action,
      command,
      state,
      reason,
      acceptedAt: "2026-01-01T12:00:00.000Z",
      pose: this.simulation.pose,
      distance: 0,
      duplicate: false,
    };
    this.#records.push(record);
    return { ...record, state: "accepted" };
  }

  async endOf(seq: number): Promise<CommandRecord> {
    const record = this.#records[seq - 1];
    if (record === undefined) throw refusal("no-command", "No command has this number.");
    return record;
  }

  cancel(seq: number): Promise<CommandRecord> {
    return this.endOf(seq);
  }

  async readMaze(): Promise<PublishedMaze> {
    return { text: JSON.stringify(this.#maze), version: "A".repeat(22) };
  }

  close(): void {
    this.isClosed = true;
  }

  #execute(command: RemoteCommand): EndingState {
    if (command.action === "reset") {
      this.simulation.reset();
      return "completed";
    }
    this.simulation.apply(command);
    do this.simulation.step();
    while (this.simulation.isManoeuvring);
    return this.simulation.ending ?? "completed";
  }

  #snapshot(): Snapshot {
    this.#seq += 1;
    return snapshotOf({ seq: this.#seq, ...this.simulation.report() });
  }
}

/** @param retryAfter s */
export function refusal(
  kind: string,
  detail: string,
  retryAfter: number | null = null,
): RefusedError {
  const problem = { type: `/problems/${kind}`, title: kind, status: 403, detail, errors: [] };
  return new RefusedError(problem, { retryAfter });
}
