/** Records runs on the workers of a pool. */
import type { WrittenRun } from "@corridor/recording";
import type { RunToRecord } from "./protocol/pool-messages.ts";
import type { WorkerPool } from "./worker-pool.ts";

/**
 * Runs in place of the pool's current job.
 * @param onRecorded receives each run, and its index in `runs`
 * @returns once all runs are recorded, or another job has taken the place of this one
 */
export async function recordRuns(
  pool: Pick<WorkerPool, "run">,
  runs: readonly RunToRecord[],
  onRecorded: (written: WrittenRun, at: number) => void,
): Promise<void> {
  let left = runs.length;
  if (left === 0) return;
  return new Promise((resolve) => {
    pool.run({ kind: "record", runs }, runs.length, {
      onResult: (result, at) => {
        if (result.kind === "record") onRecorded(result.written, at);
        if (--left === 0) resolve();
      },
      onEnd: () => resolve(),
    });
  });
}

/** Records one run. @returns null if another job has taken its place */
export async function recordRun(
  pool: Pick<WorkerPool, "run">,
  run: RunToRecord,
): Promise<WrittenRun | null> {
  const recorded: WrittenRun[] = [];
  await recordRuns(pool, [run], (written) => recorded.push(written));
  return recorded[0] ?? null;
}
