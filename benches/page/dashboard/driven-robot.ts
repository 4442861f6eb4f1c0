/** A robot that drives without end, with the tiles that the page of its student would send. */
import type { Tile } from "@corridor/protocol";
import { RunLoop } from "../../../apps/web/src/simulator/worker/run-loop.ts";
import { TileFeed } from "../../../apps/web/src/simulator/worker/tile-feed.ts";
import { benchProgram } from "../variants/bench-run.ts";
import { dashboardMaze } from "./dashboard-lesson.ts";

const STEP_MS = 20;

export class DrivenRobot {
  readonly #loop: RunLoop;
  readonly #tiles: TileFeed;
  /** of the run, in ms */
  #time = 0;

  /** @param ms how long it has driven */
  constructor(ms: number) {
    this.#loop = new RunLoop(dashboardMaze(), benchProgram(), () => this.#time);
    this.#tiles = new TileFeed({ run: () => this.#loop, now: () => this.#time });
    this.#tiles.place({ task: 1, maze: "g1", passes: null, isSolved: false, isByHand: false });
    this.#loop.run();
    while (this.#time < ms) this.#step(STEP_MS);
  }

  /** @returns the tile to send now; null if none is due */
  drive(ms: number): Tile | null {
    this.#step(ms);
    this.#tiles.changed();
    return this.#tiles.take(false);
  }

  #step(ms: number): void {
    this.#time += ms;
    this.#loop.advance();
  }
}
