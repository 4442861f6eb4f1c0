/**
 * A hundred short simulations of a robot, its script and its relay, with random faults. No command
 * or event may be lost, duplicated, reordered, ended twice or late. The real robots, store,
 * clients and the page's robot run in one process on virtual time, so that a failing seed fails
 * again.
 */
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { expect, it, onTestFinished } from "vitest";
import { FaultyWorld } from "../../testing/faults/faulty-world.ts";

const STEPS = 200;
/** Half a minute of processor time on a slow machine, which may be busy. */
const TIMEOUT_MS = 180_000;
/** Regression seeds that failed once. Do not remove them. */
const failedBefore = [58, 68, 84, 87, 95, 138, 152, 314, 322];
const seeds = Array.from({ length: 100 }, (_none, index) => index + 1);

/** A folder in memory where available, because the test checks order, not disk speed. */
function fastFolder(): string {
  const place = existsSync("/dev/shm") ? "/dev/shm" : tmpdir();
  const folder = mkdtempSync(join(place, "corridor-"));
  onTestFinished(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

it(
  "loses, duplicates, reorders or delays nothing under faults",
  async () => {
    const folder = fastFolder();
    const faults: Record<number, string[]> = {};
    for (const seed of new Set([...failedBefore, ...seeds])) {
      const found = await FaultyWorld.run(seed, folder, STEPS);
      if (found.length > 0) faults[seed] = found;
    }
    expect(faults).toEqual({});
  },
  TIMEOUT_MS,
);

it(
  "loses, duplicates, reorders or delays nothing with two relays",
  async () => {
    const folder = fastFolder();
    const faults: Record<number, string[]> = {};
    for (const seed of seeds.slice(0, 40)) {
      const found = await FaultyWorld.run(seed, folder, STEPS, 2);
      if (found.length > 0) faults[seed] = found;
    }
    expect(faults).toEqual({});
  },
  TIMEOUT_MS,
);
