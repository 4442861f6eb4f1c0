/**
 * Measures the recording of an hour's run: the time to seek to any tick, and its memory. Runs in
 * Node.js, because a recording runs in the page's worker and does not draw.
 */
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";
import { HOUR_TICKS, type HourRun } from "./hour-runs.ts";

const SEEKS = 2_000;
/** Number of seeks to each tick; the shortest counts. */
const REPETITIONS = 3;

export interface RecordingScrubReport {
  /** what drives the robot */
  name: string;
  /** milliseconds per seek to a random tick */
  p50: number;
  p99: number;
  worst: number;
  /** bytes that the recording retains, counted by V8 */
  bytes: number;
  /** bytes of the recording, counted by itself */
  countedBytes: number;
}

/** Records an hour and seeks to ticks of the recording. */
export function scrubRecording({ name, record }: HourRun): RecordingScrubReport {
  // A warm-up, so that compiled code is not counted.
  record(HOUR_TICKS / 60);
  const before = usedBytes();
  const recording = record(HOUR_TICKS);
  const bytes = usedBytes() - before;
  const playback = recording.playback();
  const times = Array.from({ length: SEEKS }, (_, index) => {
    // The same ticks in each run of the benchmark, spread over the hour in pseudorandom order.
    const tick = (index * 7_919_777) % HOUR_TICKS;
    const durations = Array.from({ length: REPETITIONS }, () => {
      playback.seek(0);
      const start = performance.now();
      playback.seek(tick);
      return performance.now() - start;
    });
    // The minimum excludes delays by other processes.
    return Math.min(...durations);
  }).toSorted((a, b) => a - b);
  const at = (share: number): number => times[Math.floor(share * (times.length - 1))] ?? Number.NaN;
  const countedBytes = recording.byteLength;
  return { name, p50: at(0.5), p99: at(0.99), worst: at(1), bytes, countedBytes };
}

/** Bytes in use after a garbage collection. */
function usedBytes(): number {
  setFlagsFromString("--expose-gc");
  const collect = runInNewContext("gc") as () => void;
  collect();
  const { heapUsed, arrayBuffers } = process.memoryUsage();
  return heapUsed + arrayBuffers;
}
