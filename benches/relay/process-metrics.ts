/**
 * Metrics of a process from Linux: processor time of all threads, and resident memory. They are
 * read from outside the process, so that every peer is measured in the same way.
 */
import { readFileSync } from "node:fs";

/**
 * /proc reports times in ticks of 1/100 s (USER_HZ), independent of the kernel's timer frequency.
 */
const MS_PER_TICK = 10;

/**
 * Processor time in milliseconds since the process started, including kernel and garbage collector.
 */
export function processorMs(pid: number): number {
  return parseProcessorMs(readFileSync(`/proc/${pid}/stat`, "utf8"));
}

/** Resident memory of the process in KiB. */
export function residentKiB(pid: number): number {
  return parseResidentKiB(readFileSync(`/proc/${pid}/status`, "utf8"));
}

/**
 * Counts the fields after the program's name, because the name may contain spaces and brackets.
 * @param text content of /proc/PID/stat
 */
export function parseProcessorMs(text: string): number {
  const fields = text.slice(text.lastIndexOf(")") + 2).split(" ");
  return (Number(fields[11]) + Number(fields[12])) * MS_PER_TICK;
}

/** @param text content of /proc/PID/status */
export function parseResidentKiB(text: string): number {
  return Number(/^VmRSS:\s+(\d+) kB$/m.exec(text)?.[1] ?? Number.NaN);
}
