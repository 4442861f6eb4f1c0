import {
  mazeOf,
  minutesFor,
  recordTrial,
  tryMaze,
} from "../../../simulator/trial-worker/maze-trial.ts";
import type { FromTrialWorker, ToTrialWorker } from "../../../simulator/protocol/trial-messages.ts";
import type { TrialPort } from "../trial-pool.ts";

/** A worker that completes its tasks on request. */
export class FakeTrialWorker implements TrialPort {
  onmessage: TrialPort["onmessage"] = null;
  onerror: TrialPort["onerror"] = null;
  isOver = false;
  /** pending tasks, the oldest first */
  readonly waiting: (() => FromTrialWorker)[] = [];

  postMessage(message: ToTrialWorker): void {
    if (message.type === "stop") this.waiting.length = 0;
    else if (message.type === "record") {
      const { maze, program: recorded, ticks } = message;
      const record = () => recordTrial(maze, recorded, ticks);
      this.waiting.push(() => ({ type: "recorded", written: record() }));
    } else this.waiting.push(...message.seeds.map((seed) => () => resultOf(message, seed)));
  }

  terminate(): void {
    this.isOver = true;
  }

  /**
   * Completes the oldest task.
   * @returns whether there was one
   */
  answer(): boolean {
    const data = this.waiting.shift()?.();
    if (data === undefined) return false;
    this.onmessage?.({ data } as MessageEvent<FromTrialWorker>);
    return true;
  }
}

function resultOf(
  { job, mazes, program: tried }: Extract<ToTrialWorker, { type: "try" }>,
  seed: number,
): FromTrialWorker {
  const maze = mazeOf(mazes, seed);
  const result = { seed, maze, ...tryMaze(maze, tried, minutesFor(mazes.side)) };
  return { type: "result", job, result };
}
