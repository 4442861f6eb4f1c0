import type {
  RemoteCommand,
  DeliveredCommand,
  Pose,
  Registration,
  Snapshot,
} from "@corridor/protocol";
import { HostConnection, type HostStatus } from "../../../packages/client/src/host-connection.ts";

/** x and y by quarter turns clockwise from north */
const STEPS = [
  [0, -1],
  [1, 0],
  [0, 1],
  [-1, 0],
] as const;

/**
 * A robot for tests that hosts itself at a relay, as a page does. It stands on a grid of cells and
 * executes every command at once. It records all commands, so that tests notice duplicates.
 */
export class GridRobot {
  readonly connection: HostConnection;
  readonly done: RemoteCommand[] = [];
  readonly visited = new Set<string>();
  /** null: there is none */
  goal: { column: number; row: number } | null = null;
  readonly statuses: HostStatus["kind"][] = [];
  readonly #rows: readonly string[];
  #column: number;
  #row: number;
  #quarter = 0;
  #seq = 0;
  #bumps = 0;

  /** @param rows `#` block, `.` open. The robot starts in the first open cell and faces north */
  constructor(origin: string, credentials: Registration, rows: readonly string[]) {
    this.#rows = rows;
    this.#row = rows.findIndex((row) => row.includes("."));
    this.#column = rows[this.#row]?.indexOf(".") ?? 0;
    this.#visit();
    this.connection = new HostConnection({
      origin,
      credentials,
      lastApplied: 0,
      fresh: true,
      snapshot: () => this.snapshot(),
      onCommand: (command) => this.#execute(command),
      onStop: () => undefined,
      onCancel: () => undefined,
      onGiveBack: () => undefined,
      onYield: () => undefined,
      onState: () => undefined,
      onRefused: () => undefined,
      onStatus: ({ kind }) => {
        this.statuses.push(kind);
        if (kind === "connected") this.connection.sendSnapshot(this.snapshot());
      },
      onDrivers: () => undefined,
    });
  }

  get openCells(): number {
    return this.#rows.join("").replaceAll("#", "").length;
  }

  snapshot(): Snapshot {
    this.#seq += 1;
    return {
      seq: this.#seq,
      tick: this.#seq,
      state: "running",
      driver: "remote",
      sensors: {
        front: this.#distance(0),
        right: this.#distance(1),
        back: this.#distance(2),
        left: this.#distance(3),
      },
      pose: this.#pose,
      motion: "stop",
      bumps: this.#bumps,
      bumping: false,
      goalReached: this.goal !== null && this.visited.has(`${this.goal.column},${this.goal.row}`),
      line: null,
      command: null,
    };
  }

  get #pose(): Pose {
    return {
      x: this.#column * 100 + 50,
      y: this.#row * 100 + 50,
      heading: this.#quarter * 90,
    };
  }

  #execute({ seq, command }: DeliveredCommand): void {
    this.done.push(command);
    this.connection.started(seq);
    const isFree = this.#move(command);
    this.#visit();
    this.connection.ended(seq, {
      state: isFree ? "completed" : "collided",
      reason: null,
      pose: this.#pose,
      distance: command.action === "move" && isFree ? Math.abs(command.distance) : 0,
    });
  }

  #move(command: RemoteCommand): boolean {
    if (command.action === "left 90") this.#quarter = (this.#quarter + 3) % 4;
    if (command.action === "right 90") this.#quarter = (this.#quarter + 1) % 4;
    if (command.action === "turn") {
      this.#quarter = (this.#quarter + 4 + (Math.round(command.degrees / 90) % 4)) % 4;
    }
    // A short move, such as a script's to the middle of a cell, stays in the cell.
    if (command.action !== "move" || Math.abs(command.distance) < 50) return true;
    const turned = command.distance < 0 ? 2 : 0;
    if (this.#distance(turned) <= 50) {
      this.#bumps += 1;
      return false;
    }
    const [x, y] = STEPS[(this.#quarter + turned) % 4] ?? STEPS[0];
    this.#column += x;
    this.#row += y;
    return true;
  }

  /**
   * cm from the centre to the first block.
   * @param turned quarter turns clockwise from the heading
   */
  #distance(turned: number): number {
    const [x, y] = STEPS[(this.#quarter + turned) % 4] ?? STEPS[0];
    let cells = 0;
    while (this.#rows[this.#row + y * (cells + 1)]?.[this.#column + x * (cells + 1)] === ".") {
      cells += 1;
    }
    return cells * 100 + 50;
  }

  #visit(): void {
    this.visited.add(`${this.#column},${this.#row}`);
  }
}
