/** A robot that drives without end, with the tiles that the page of its student would send. */
import { mazeOf } from "@corridor/challenge";
import type { Tile } from "@corridor/protocol";
import { RunLoop } from "../../../apps/web/src/simulator/worker/run-loop.ts";
import { TileFeed } from "../../../apps/web/src/simulator/worker/tile-feed.ts";
import { benchProgram } from "../variants/bench-run.ts";
import { dashboardLesson, UNSEEN_MAZES } from "./dashboard-lesson.ts";

const STEP_MS = 20;
const task = dashboardLesson().tasks[0];

export class DrivenRobot {
  #loop: RunLoop;
  readonly #tiles: TileFeed;
  /** number of its unseen maze; null: it drives in the given maze, which has no end */
  #unseen: number | null;
  /** of the run, in ms */
  #time = 0;

  /**
   * @param ms how long it has driven
   * @param unseen number of its first unseen maze; from the goal it goes to the next one
   */
  constructor(ms: number, unseen: number | null = null) {
    this.#unseen = unseen;
    this.#loop = this.#start();
    this.#tiles = new TileFeed({ run: () => this.#loop, now: () => this.#time });
    this.#place();
    while (this.#time < ms) this.#step(STEP_MS);
  }

  /** @returns the tile to send now; null if none is due */
  drive(ms: number): Tile | null {
    this.#step(ms);
    this.#tiles.changed();
    return this.#tiles.take(false);
  }

  #start(): RunLoop {
    if (task === undefined) throw new Error("the lesson has no task");
    const maze = mazeOf(task, this.#unseen ?? 0);
    const loop = new RunLoop(maze, benchProgram(), () => this.#time);
    loop.run();
    return loop;
  }

  #place(): void {
    const maze = this.#unseen === null ? "g1" : `u${this.#unseen}`;
    this.#tiles.place({ task: 1, maze, passes: null, isSolved: false, isDriven: false });
  }

  #step(ms: number): void {
    this.#time += ms;
    this.#loop.advance();
    if (this.#loop.isRunning || this.#unseen === null) return;
    this.#unseen = (this.#unseen % UNSEEN_MAZES) + 1;
    this.#loop = this.#start();
    this.#place();
  }
}
