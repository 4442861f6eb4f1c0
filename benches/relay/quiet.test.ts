import { expect, it } from "vitest";
import { whenQuiet } from "./quiet.ts";

const LOOK_MS = 10;

it("waits until nobody works, twice in a row", async () => {
  // Of each look: how much more one of the two has used by then.
  const steps = [0, 9, 9, 0, 9, 1, 0, 9];
  let looks = 0;
  let used = 0;
  const usedMs = (pid: number): number => {
    if (pid === 2) used += steps[looks++] ?? 0;
    return pid === 2 ? used : 7;
  };
  await whenQuiet([1, 2], usedMs, LOOK_MS);
  expect(looks).toBe(7);
});

it("says so where somebody works for ever", async () => {
  let used = 0;
  await expect(whenQuiet([4], () => (used += 5), 1)).rejects.toThrow(/4 works on and on/);
});
