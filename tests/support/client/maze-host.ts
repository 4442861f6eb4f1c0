/** A robot in a maze that hosts itself at a relay, as a page does, and publishes its maze. */
import type { DeliveredCommand, Marks, Registration } from "@corridor/protocol";
import type { MazeDocument } from "@corridor/maze";
import { MazeRobot } from "../../../packages/agent/src/testing/maze-robot.ts";
import { HostConnection } from "../../../packages/client/src/host-connection.ts";

export class MazeHost {
  readonly robot: MazeRobot;
  readonly connection: HostConnection;
  readonly connected: Promise<void>;
  /** false: commands start, and end with `endAll` */
  endsCommands = true;
  /** marks of scripts */
  readonly marks: Marks[] = [];
  /** number of started commands */
  started = 0;
  readonly #running: DeliveredCommand[] = [];

  constructor(origin: string, credentials: Registration, maze: MazeDocument) {
    this.robot = new MazeRobot(maze);
    const connected = Promise.withResolvers<void>();
    this.connected = connected.promise;
    this.connection = new HostConnection({
      origin,
      credentials,
      lastApplied: 0,
      fresh: true,
      snapshot: () => this.robot.snapshot(),
      onCommand: (command) => this.#start(command),
      onStop: () => this.endAll("cancelled"),
      onCancel: () => this.endAll("cancelled"),
      onGiveBack: () => undefined,
      onYield: () => undefined,
      onState: () => undefined,
      onRefused: () => undefined,
      onStatus: ({ kind }) => {
        if (kind !== "connected") return;
        this.connection.sendSnapshot(this.robot.snapshot());
        connected.resolve();
      },
      onMarks: (marks) => void this.marks.push(marks),
      onDrivers: () => undefined,
    });
  }

  /** Publishes the maze, as the page does. */
  static async publish(origin: string, robot: Registration, maze: MazeDocument): Promise<void> {
    await fetch(`${origin}/api/v1/robots/${robot.id}/maze`, {
      method: "PUT",
      headers: {
        Authorization: `Bearer ${robot.ownerKey}`,
        "Content-Type": "application/json",
      },
      body: JSON.stringify(maze),
    });
  }

  /** number of commands that have not ended */
  get running(): number {
    return this.#running.length;
  }

  endAll(state: "completed" | "cancelled"): void {
    for (const { seq } of this.#running.splice(0)) this.#end(seq, { state, distance: 0 });
  }

  #start(command: DeliveredCommand): void {
    const { seq } = command;
    this.started += 1;
    this.connection.started(seq);
    if (this.endsCommands) this.#end(seq, this.robot.execute(command.command));
    else this.#running.push(command);
  }

  #end(seq: number, result: ReturnType<MazeRobot["execute"]>): void {
    this.connection.sendSnapshot(this.robot.snapshot());
    this.connection.ended(seq, { ...result, reason: null, pose: this.robot.pose });
  }
}
