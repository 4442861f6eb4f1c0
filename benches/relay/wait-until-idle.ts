/**
 * Waits for idle processes between two rounds, so that deferred work of one peer affects neither
 * the round of another peer nor its own next round.
 */
import { delay } from "./load/load-recorder.ts";
import { processorMs } from "./process-metrics.ts";

const INTERVAL_MS = 250;
/** Idle processes still send heartbeats. */
const MAX_BUSY_SHARE = 0.1;
/** A single idle interval may be a gap between two tasks. */
const IDLE_INTERVALS = 2;
const MAX_INTERVALS = 240;

/**
 * Waits until all processes are idle.
 * @param usedMs processor time in milliseconds since the start of a process
 * @throws Error if a process is not idle within one minute
 */
export async function waitUntilIdle(
  pids: readonly number[],
  usedMs: (pid: number) => number = processorMs,
  intervalMs = INTERVAL_MS,
): Promise<void> {
  let before = pids.map(usedMs);
  let idleIntervals = 0;
  for (let interval = 0; interval < MAX_INTERVALS; interval++) {
    await delay(intervalMs);
    const now = pids.map(usedMs);
    const areIdle = now.every((ms, at) => ms - (before[at] ?? 0) <= intervalMs * MAX_BUSY_SHARE);
    before = now;
    idleIntervals = areIdle ? idleIntervals + 1 : 0;
    if (idleIntervals === IDLE_INTERVALS) return;
  }
  throw new Error(`One of the processes ${pids.join(", ")} did not become idle.`);
}
