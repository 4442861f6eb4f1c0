/** What a contender does after its turn must neither be done during that of another, nor spoil its own next one. */
import { pause } from "./load/watch.ts";
import { processorMs } from "./process-figures.ts";

const LOOK_MS = 250;
/** Heartbeats go on. */
const MOST_BUSY = 0.1;
/** One look may fall between two pieces of work. */
const LOOKS = 2;
const LONGEST_LOOKS = 240;

/**
 * Waits until none of these processes does more than it does at rest.
 * @param usedMs ms on a processor since the process began
 * @throws Error when one of them works for a minute
 */
export async function whenQuiet(
  pids: readonly number[],
  usedMs: (pid: number) => number = processorMs,
  lookMs = LOOK_MS,
): Promise<void> {
  let before = pids.map(usedMs);
  let quiet = 0;
  for (let looks = 0; looks < LONGEST_LOOKS; looks++) {
    await pause(lookMs);
    const now = pids.map(usedMs);
    const isQuiet = now.every((ms, at) => ms - (before[at] ?? 0) <= lookMs * MOST_BUSY);
    before = now;
    quiet = isQuiet ? quiet + 1 : 0;
    if (quiet === LOOKS) return;
  }
  throw new Error(`One of the processes ${pids.join(", ")} works on and on.`);
}
