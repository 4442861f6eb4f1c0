/** One core of `grade`: runs the batches of pairs it is sent, and ends when it is sent null. */
import { parentPort, workerData } from "node:worker_threads";
import { gradePair, type GradeJob, type WorkerAnswer } from "./grade.ts";

const job = workerData as GradeJob;

parentPort?.on("message", (batch: { from: number; to: number } | null) => {
  if (batch === null) {
    parentPort?.close();
    return;
  }
  const batchResults = Array.from({ length: batch.to - batch.from }, (_, index) =>
    gradePair(job, batch.from + index),
  );
  parentPort?.postMessage({ from: batch.from, batchResults } satisfies WorkerAnswer);
});
