/**
 * Notices a robot that gets nowhere: one that passes the same border between two squares the same way
 * again and again, one that pushes against a wall, and one that does not leave its square. Looks at
 * each tick, keeps a few bytes a square.
 *
 * A robot that has been on every square that it can reach has done its round, and may go on with it.
 */
import { distancesFromStart, UNREACHABLE, type MazeDocument } from "@corridor/maze";
import type { LineRef } from "@corridor/protocol";

/** As often as this the same way is no coincidence. */
const PASSES = 3;
/** Two seconds at a wall: a program that meant to turn has had its chance. */
const PUSHING_TICKS = 120;
/** Fifteen seconds: longer than any manoeuvres that a square takes. */
const STAYING_TICKS = 900;

export interface LoopNotice {
  kind: "circles" | "pushing" | "staying";
  /** the line to look at: the one that turned last, or that pushes or stays */
  line: LineRef;
  /** `row * columns + column` */
  cell: number;
  /** how often it has passed here the same way; 0 for a robot that pushes or stays */
  times: number;
}

export class LoopWatch {
  readonly #columns: number;
  /** passes by square and way in: from above, from the right, from below, from the left */
  readonly #passes: Uint8Array;
  readonly #isVisited: Uint8Array;
  /** reachable squares where the robot has not been */
  #unseen: number;
  #cell = -1;
  #pushed = 0;
  #stayed = 0;
  #turner: LineRef | null = null;
  #hasTold = false;

  constructor(maze: MazeDocument) {
    const distances = distancesFromStart(maze);
    this.#columns = maze.blocks[0]?.length ?? 0;
    this.#passes = new Uint8Array(distances.length * 4);
    this.#isVisited = Uint8Array.from(distances, (distance) => (distance === UNREACHABLE ? 1 : 0));
    this.#unseen = distances.length - this.#isVisited.reduce((sum, each) => sum + each, 0);
  }

  /**
   * Looks at the end of a tick. Numbers and flags, no object: this runs on every tick.
   * @param cell `row * columns + column` of the square under the robot's middle
   * @param isStopped whether a wall stopped the robot in this tick
   * @param isTurning whether a manoeuvre runs, so that its line is what leads the robot round
   * @param line the line that decides or began the manoeuvre that runs
   * @param isWaiting whether the line says `stop`: who stands where it was told to has arrived
   * @returns what there is to say, at most once
   */
  look(
    cell: number,
    isStopped: boolean,
    isTurning: boolean,
    line: LineRef,
    isWaiting: boolean,
  ): LoopNotice | null {
    if (this.#hasTold) return null;
    if (isTurning) this.#turner = line;
    this.#pushed = isStopped ? this.#pushed + 1 : 0;
    if (this.#pushed >= PUSHING_TICKS) return this.#tell("pushing", line, cell, 0);
    const before = this.#cell;
    this.#stayed = cell === before && !isWaiting ? this.#stayed + 1 : 0;
    if (this.#stayed >= STAYING_TICKS) return this.#tell("staying", line, cell, 0);
    if (cell === before) return null;
    this.#cell = cell;
    this.#see(cell);
    const way = this.#wayFrom(before, cell);
    if (way === null) return null;
    const at = cell * 4 + way;
    const times = (this.#passes[at] ?? 0) + 1;
    this.#passes[at] = times;
    if (times < PASSES || this.#unseen === 0) return null;
    return this.#tell("circles", this.#turner ?? line, cell, times);
  }

  #tell(kind: LoopNotice["kind"], line: LineRef, cell: number, times: number): LoopNotice {
    this.#hasTold = true;
    return { kind, line, cell, times };
  }

  #see(cell: number): void {
    if (this.#isVisited[cell] !== 0) return;
    this.#isVisited[cell] = 1;
    this.#unseen--;
  }

  /** The side through which the robot came in; null for one that was put here. */
  #wayFrom(before: number, cell: number): number | null {
    if (before < 0) return null;
    if (cell === before + this.#columns) return 0;
    if (cell === before - 1) return 1;
    if (cell === before - this.#columns) return 2;
    return cell === before + 1 ? 3 : null;
  }
}
