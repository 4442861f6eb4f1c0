/**
 * A robot in a maze for tests, which drives at once in steps of 1 cm. It turns by quarters only, and
 * stops at walls as the real one does.
 */
import { CELL, isBlock, type MazeDocument } from "@corridor/maze";
import { CompiledConditions } from "@corridor/program";
import {
  sensorNames,
  type EndingState,
  type Pose,
  type RemoteCommand,
  type Snapshot,
  type UntilCondition,
} from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";

const RADIUS = 25;
/** x and y by quarter turns clockwise from north */
const directions = [
  [0, -1],
  [1, 0],
  [0, 1],
  [-1, 0],
] as const;
const quarters = { north: 0, east: 1, south: 2, west: 3 } as const;
const turns: Record<string, number> = { "left 90": 3, "right 90": 1, "turn 180": 2 };

export interface MotionResult {
  state: EndingState;
  distance: number;
}

export class MazeRobot {
  readonly maze: MazeDocument;
  /** all commands that it executed, so that tests notice duplicates */
  readonly done: RemoteCommand[] = [];
  #x = 0;
  #y = 0;
  #quarter = 0;
  #seq = 0;
  #bumps = 0;
  #goalReached = false;

  constructor(maze: MazeDocument) {
    this.maze = maze;
    this.#reset();
  }

  get pose(): Pose {
    return { x: this.#x, y: this.#y, heading: this.#quarter * 90 };
  }

  snapshot(change: Partial<Snapshot> = {}): Snapshot {
    this.#seq += 1;
    const [front, right, back, left] = this.#readings();
    return snapshotOf({
      seq: this.#seq,
      tick: this.#seq * 60,
      sensors: { front: front ?? 0, right: right ?? 0, back: back ?? 0, left: left ?? 0 },
      pose: this.pose,
      bumps: this.#bumps,
      goalReached: this.#goalReached,
      ...change,
    });
  }

  execute(command: RemoteCommand): MotionResult {
    this.done.push(command);
    const { action } = command;
    if (action === "reset") this.#reset();
    if (action === "move") return this.#drive(command.distance, []);
    if (action === "forward") return this.#drive(Number.POSITIVE_INFINITY, command.until ?? []);
    const turned = action === "turn" ? Math.round(command.degrees / 90) : (turns[action] ?? 0);
    this.#quarter = (this.#quarter + turned + 4) % 4;
    return { state: "completed", distance: 0 };
  }

  #reset(): void {
    const { column, row, heading } = this.maze.start;
    this.#x = column * CELL + CELL / 2;
    this.#y = row * CELL + CELL / 2;
    this.#quarter = quarters[heading];
    this.#bumps = 0;
    this.#goalReached = false;
  }

  #drive(distance: number, until: readonly UntilCondition[]): MotionResult {
    const conditions = new CompiledConditions(until);
    const turned = distance < 0 ? 2 : 0;
    const [dx, dy] = directions[(this.#quarter + turned) % 4] ?? directions[0];
    let driven = 0;
    while (driven < Math.abs(distance)) {
      if (conditions.firstTrue(this.#readings(), this.#isInGoal()) >= 0) break;
      if (this.#distance(turned) <= RADIUS) {
        this.#bumps += 1;
        return { state: "collided", distance: driven };
      }
      this.#x += dx;
      this.#y += dy;
      driven += 1;
      this.#goalReached ||= this.#isInGoal();
    }
    return { state: "completed", distance: driven };
  }

  #readings(): Float64Array {
    return Float64Array.from(sensorNames, (_, turned) => this.#distance(turned));
  }

  /** cm from the centre to the first block. @param turned quarter turns clockwise from the heading */
  #distance(turned: number): number {
    const [dx, dy] = directions[(this.#quarter + turned) % 4] ?? directions[0];
    let cells = 1;
    while (!this.#isBlock(this.#x + dx * cells * CELL, this.#y + dy * cells * CELL)) cells += 1;
    const along = dx === 0 ? this.#y : this.#x;
    const within = along % CELL;
    const toEdge = dx + dy > 0 ? CELL - within : within;
    return toEdge + (cells - 1) * CELL;
  }

  #isBlock(x: number, y: number): boolean {
    return isBlock(this.maze, Math.floor(x / CELL), Math.floor(y / CELL));
  }

  /** Whether the whole robot stands in a goal cell. */
  #isInGoal(): boolean {
    const isInside = (at: number, index: number): boolean =>
      Math.abs(at - index * CELL - CELL / 2) <= CELL / 2 - RADIUS;
    return this.maze.goals.some(
      ({ column, row }) => isInside(this.#x, column) && isInside(this.#y, row),
    );
  }
}
