/** The memory of a process. */
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";

/**
 * Reads the memory from a file where possible: starting a program would disturb the measurement.
 */
export function memoryMib(pid: number): number {
  const file = `/proc/${pid}/status`;
  if (existsSync(file)) {
    return Number(/VmRSS:\s+(\d+) kB/.exec(readFileSync(file, "utf8"))?.[1]) / 1024;
  }
  const { stdout } = spawnSync("ps", ["-o", "rss=", "-p", String(pid)], { encoding: "utf8" });
  return Number(stdout) / 1024;
}
