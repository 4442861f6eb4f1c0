/**
 * What the past of an hour's run costs: the time that it takes to show any moment of it, and the memory
 * that it holds. In Node, since it runs in the page's worker and draws nothing.
 */
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";
import { HOUR, type Hour } from "./hours.ts";

const SEEKS = 2_000;
/** Each moment is gone to so often; the shortest counts. */
const VISITS = 3;

export interface ScrubReport {
  /** what drives for an hour */
  name: string;
  /** milliseconds that it takes to go to a random moment */
  p50: number;
  p99: number;
  worst: number;
  /** bytes that the recording keeps alive, as the engine counts them */
  bytes: number;
  /** the same by the recording's own count */
  counted: number;
}

/** Records an hour and goes through it. */
export function scrubReport({ name, record }: Hour): ScrubReport {
  // Once beforehand, so that what the engine compiles is not counted.
  record(HOUR / 60);
  const before = heldBytes();
  const recording = record(HOUR);
  const bytes = heldBytes() - before;
  const playback = recording.playback();
  const times = Array.from({ length: SEEKS }, (_, index) => {
    // The same moments each time, spread over the hour and in no order.
    const tick = (index * 7_919_777) % HOUR;
    const visits = Array.from({ length: VISITS }, () => {
      playback.goTo(0);
      const from = performance.now();
      playback.goTo(tick);
      return performance.now() - from;
    });
    // What other processes took of the processor meanwhile is not the recording's.
    return Math.min(...visits);
  }).toSorted((a, b) => a - b);
  const at = (part: number): number => times[Math.floor(part * (times.length - 1))] ?? Number.NaN;
  const counted = recording.byteLength;
  return { name, p50: at(0.5), p99: at(0.99), worst: at(1), bytes, counted };
}

/** Bytes in use after a collection. */
function heldBytes(): number {
  setFlagsFromString("--expose-gc");
  const collect = runInNewContext("gc") as () => void;
  collect();
  const { heapUsed, arrayBuffers } = process.memoryUsage();
  return heapUsed + arrayBuffers;
}
