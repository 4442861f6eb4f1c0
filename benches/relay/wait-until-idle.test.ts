import { expect, it } from "vitest";
import { waitUntilIdle } from "./wait-until-idle.ts";

const INTERVAL_MS = 10;

it("waits until all processes are idle in two consecutive intervals", async () => {
  // Processor time that one of the two processes uses in each interval.
  const steps = [0, 9, 9, 0, 9, 1, 0, 9];
  let interval = 0;
  let used = 0;
  const usedMs = (pid: number): number => {
    if (pid === 2) used += steps[interval++] ?? 0;
    return pid === 2 ? used : 7;
  };
  await waitUntilIdle([1, 2], usedMs, INTERVAL_MS);
  expect(interval).toBe(7);
});

it("rejects when a process never becomes idle", async () => {
  let used = 0;
  await expect(waitUntilIdle([4], () => (used += 5), 1)).rejects.toThrow(/4 did not become idle/);
});
