/** Tries programs in other mazes beside the page. One message in, one answer out, in the same order. */
import { mazeOf, minutesFor, recordTrial, tryMaze } from "./maze-trial.ts";
import type { FromTrialWorker, ToTrialWorker } from "./trial-messages.ts";

const worker = self as unknown as DedicatedWorkerGlobalScope;

worker.onmessage = ({ data }: MessageEvent<ToTrialWorker>) => {
  worker.postMessage(answer(data));
};

function answer(message: ToTrialWorker): FromTrialWorker {
  if (message.type === "record") {
    return { type: "recorded", written: recordTrial(message.maze, message.program, message.ticks) };
  }
  const { job, program, mazes, seed } = message;
  const maze = mazeOf(mazes, seed);
  const trial = tryMaze(maze, program, minutesFor(mazes.side));
  return { type: "result", job, result: { seed, maze, ...trial } };
}
