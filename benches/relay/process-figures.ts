/**
 * What a process has cost so far, as Linux counts it: processor time of all its threads, and the memory
 * that it has in use. From outside, so that every contender is measured alike and none helps.
 */
import { readFileSync } from "node:fs";

/** Linux counts in hundredths of a second for all who ask, whatever the kernel's own beat is. */
const MS_A_TICK = 10;

/** Milliseconds on a processor since the process began, garbage collector and kernel included. */
export function processorMs(pid: number): number {
  return processorMsIn(readFileSync(`/proc/${pid}/stat`, "utf8"));
}

/** KiB of memory that the process has in use. */
export function residentKiB(pid: number): number {
  return residentKiBIn(readFileSync(`/proc/${pid}/status`, "utf8"));
}

/** @param text of /proc/PID/stat. A program's name may hold spaces and brackets, so counting begins after it. */
export function processorMsIn(text: string): number {
  const fields = text.slice(text.lastIndexOf(")") + 2).split(" ");
  return (Number(fields[11]) + Number(fields[12])) * MS_A_TICK;
}

/** @param text of /proc/PID/status */
export function residentKiBIn(text: string): number {
  return Number(/^VmRSS:\s+(\d+) kB$/m.exec(text)?.[1] ?? Number.NaN);
}
