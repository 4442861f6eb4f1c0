import { distancesFromStart, UNREACHABLE, type MazeDocument } from "@corridor/maze";
import type { LineRef } from "@corridor/protocol";

/** Passes of the same border in the same direction that count as a loop. */
const PASSES = 3;
/** Two seconds at a wall: longer than a program needs to turn. */
const PUSHING_TICKS = 120;
/** Fifteen seconds: longer than all manoeuvres on one square. */
const STAYING_TICKS = 900;

export interface LoopNotice {
  kind: "circles" | "pushing" | "staying";
  /** the line that turned last, or that pushes or stays */
  line: LineRef;
  /** `row * columns + column` */
  cell: number;
  /** number of passes in the same direction; 0 for a robot that pushes or stays */
  times: number;
}

/**
 * Detects a robot that makes no progress: it passes the same border between two squares repeatedly
 * in the same direction, pushes against a wall, or does not leave its square. It is updated on each
 * tick and stores a few bytes per square.
 *
 * A robot that has visited every reachable square may repeat its path.
 */
export class LoopDetector {
  readonly #columns: number;
  /** passes by square and direction: from above, from the right, from below, from the left */
  readonly #passes: Uint8Array;
  readonly #isVisited: Uint8Array;
  /** reachable squares that the robot has not visited */
  #unvisited: number;
  #cell = -1;
  #pushed = 0;
  #stayed = 0;
  #lastTurn: LineRef | null = null;
  #hasReported = false;

  constructor(maze: MazeDocument) {
    const distances = distancesFromStart(maze);
    this.#columns = maze.blocks[0]?.length ?? 0;
    this.#passes = new Uint8Array(distances.length * 4);
    this.#isVisited = Uint8Array.from(distances, (distance) => (distance === UNREACHABLE ? 1 : 0));
    this.#unvisited = distances.length - this.#isVisited.reduce((sum, each) => sum + each, 0);
  }

  /**
   * To be called at the end of each tick. Takes plain values, because it runs on every tick.
   * @param cell `row * columns + column` of the square under the robot's centre
   * @param isStopped whether a wall stopped the robot in this tick
   * @param isTurning whether a manoeuvre runs: its line determines the robot's path
   * @param line the line that decides, or that started the running manoeuvre
   * @param isWaiting whether the action is `stop`: the robot stands on purpose
   * @returns the first notice, once; otherwise null
   */
  update(
    cell: number,
    isStopped: boolean,
    isTurning: boolean,
    line: LineRef,
    isWaiting: boolean,
  ): LoopNotice | null {
    if (this.#hasReported) return null;
    if (isTurning) this.#lastTurn = line;
    this.#pushed = isStopped ? this.#pushed + 1 : 0;
    if (this.#pushed >= PUSHING_TICKS) return this.#notice("pushing", line, cell, 0);
    const before = this.#cell;
    this.#stayed = cell === before && !isWaiting ? this.#stayed + 1 : 0;
    if (this.#stayed >= STAYING_TICKS) return this.#notice("staying", line, cell, 0);
    if (cell === before) return null;
    this.#cell = cell;
    this.#visit(cell);
    const side = this.#entrySide(before, cell);
    if (side === null) return null;
    const at = cell * 4 + side;
    const times = (this.#passes[at] ?? 0) + 1;
    this.#passes[at] = times;
    if (times < PASSES || this.#unvisited === 0) return null;
    return this.#notice("circles", this.#lastTurn ?? line, cell, times);
  }

  #notice(kind: LoopNotice["kind"], line: LineRef, cell: number, times: number): LoopNotice {
    this.#hasReported = true;
    return { kind, line, cell, times };
  }

  #visit(cell: number): void {
    if (this.#isVisited[cell] !== 0) return;
    this.#isVisited[cell] = 1;
    this.#unvisited--;
  }

  /** The side through which the robot entered; null if it was placed here. */
  #entrySide(before: number, cell: number): number | null {
    if (before < 0) return null;
    if (cell === before + this.#columns) return 0;
    if (cell === before - 1) return 1;
    if (cell === before - this.#columns) return 2;
    return cell === before + 1 ? 3 : null;
  }
}
