/** Tries programs in other mazes, one after the other, and handles messages in between. */
import { mazeOf, minutesFor, recordTrial, tryMaze } from "./maze-trial.ts";
import type { FromTrialWorker, ToTrialWorker } from "../protocol/trial-messages.ts";

type Trial = Omit<Extract<ToTrialWorker, { type: "try" }>, "type" | "seeds"> & { seed: number };

const worker = self as unknown as DedicatedWorkerGlobalScope;
const post = (message: FromTrialWorker): void => worker.postMessage(message);

let waiting: Trial[] = [];
const { port1: turn, port2: turns } = new MessageChannel();

worker.onmessage = ({ data }: MessageEvent<ToTrialWorker>) => {
  if (data.type === "try") {
    const { job, program, mazes, seeds } = data;
    waiting.push(...seeds.map((seed) => ({ job, program, mazes, seed })));
    turn.postMessage(null);
    return;
  }
  waiting = [];
  if (data.type === "stop") return;
  post({ type: "recorded", written: recordTrial(data.maze, data.program, data.ticks) });
};

turns.onmessage = () => {
  const trial = waiting.shift();
  if (trial === undefined) return;
  const { job, program, mazes, seed } = trial;
  const maze = mazeOf(mazes, seed);
  post({
    type: "result",
    job,
    result: { seed, maze, ...tryMaze(maze, program, minutesFor(mazes.side)) },
  });
  turn.postMessage(null);
};
