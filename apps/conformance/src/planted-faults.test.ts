/** Each check of the kit catches a fault that is planted in the physical robot, as the first of all checks. */
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { groups, runChecks, type Result } from "./run-checks.ts";
import { plantedFaults, type PlantedFault } from "./testing/planted-faults.ts";
import { PEN, startPhysicalRobot, type RunningRobot } from "./testing/physical-robot.ts";

/** Robots at the same time: a run mostly waits for leases and times to live. */
const AT_ONCE = 40;
const RUN_MS = 300_000;

const running = new Set<RunningRobot>();

async function firstFailure({ edits }: PlantedFault): Promise<Result | undefined> {
  const robot = await startPhysicalRobot({ room: PEN, haste: 8, isTracked: true, edits });
  running.add(robot);
  try {
    const results = await runChecks(robot.address, { stopsAtFailure: true });
    return results.find(({ outcome }) => outcome.kind === "failed");
  } finally {
    robot.stop();
    running.delete(robot);
  }
}

describe("planted faults", () => {
  const outcomes = new Map<PlantedFault, Result | undefined | Error>();

  beforeAll(async () => {
    // The longest runs first: a late check is reached after all others.
    const rest = [...plantedFaults];
    const work = Array.from({ length: AT_ONCE }, async () => {
      for (let fault = rest.pop(); fault !== undefined; fault = rest.pop()) {
        const found = await firstFailure(fault).catch((error: unknown) => error as Error);
        outcomes.set(fault, found);
      }
    });
    await Promise.all(work);
  }, RUN_MS);

  afterAll(() => {
    for (const robot of running) robot.stop();
  });

  it.each(plantedFaults)("$fault: caught by $caughtBy", (fault) => {
    const found = outcomes.get(fault);
    if (found instanceof Error) throw found;
    // The whole of what failed, for whoever reads that another check was first.
    expect(found).toMatchObject({ promise: fault.caughtBy });
  });

  it("are there for every check", () => {
    const checks = groups.flatMap((group) => group.checks.map(({ promise }) => promise));
    const caught = new Set(plantedFaults.map(({ caughtBy }) => caughtBy));
    expect(checks.filter((promise) => !caught.has(promise))).toEqual([]);
  });
});
