/**
 * The example of a physical robot passes the kit, and each check catches a fault that is planted in a
 * copy of it, as the first of all checks.
 */
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { connections } from "./checks/connections.ts";
import { passes } from "./report.ts";
import { groups, runChecks, type Outcome, type Result, type RunOptions } from "./run-checks.ts";
import { plantedFaults, type PlantedFault } from "./testing/planted-faults.ts";
import {
  PEN,
  startPhysicalRobot,
  type RobotOptions,
  type RunningRobot,
} from "./testing/physical-robot.ts";
import { startBridge, type BridgeFault } from "./testing/websocket-bridge.ts";

/** Robots at the same time: a run mostly waits for leases and times to live. */
const AT_ONCE = 24;
/** They give up then. */
const RUN_MS = 600_000;

const running = new Set<RunningRobot>();

async function kitOn(robotOptions: Partial<RobotOptions>, options?: RunOptions): Promise<Result[]> {
  const robot = await startPhysicalRobot({ room: PEN, haste: 8, ...robotOptions });
  running.add(robot);
  try {
    return await runChecks(robot.address, options);
  } finally {
    robot.stop();
    running.delete(robot);
  }
}

async function firstFailure({ edits, bridge }: PlantedFault): Promise<Result | undefined> {
  const results =
    bridge === undefined
      ? await kitOn({ isTracked: true, edits }, { stopsAtFailure: true })
      : await connectionsOn(bridge);
  return results.find(({ outcome }) => outcome.kind === "failed");
}

/** What the checks of connections say of the example with a WebSocket; all others see the same as without. */
async function connectionsOn(fault?: BridgeFault): Promise<Result[]> {
  const robot = await startPhysicalRobot({ room: PEN, haste: 8, isTracked: true });
  running.add(robot);
  const bridge = await startBridge(robot.address, fault);
  try {
    return await runChecks(bridge.address, { groups: [connections], stopsAtFailure: true });
  } finally {
    bridge.stop();
    robot.stop();
    running.delete(robot);
  }
}

describe("the physical robot", () => {
  const outcomes = new Map<PlantedFault, Result | undefined | Error>();
  let unchanged: Result[] = [];
  let bridged: Result[] = [];

  beforeAll(async () => {
    // The longest runs first: a late check is reached after all others.
    const rest = [...plantedFaults];
    const work = Array.from({ length: AT_ONCE }, async () => {
      for (let fault = rest.pop(); fault !== undefined; fault = rest.pop()) {
        const found = await firstFailure(fault).catch((error: unknown) => error as Error);
        outcomes.set(fault, found);
      }
    });
    [unchanged, bridged] = await Promise.all([kitOn({}), connectionsOn(), ...work]);
  }, RUN_MS);

  afterAll(() => {
    for (const robot of running) robot.stop();
  });

  it("does all that scripts rely on, and says what it does not offer", () => {
    const of = (kind: Outcome["kind"]) =>
      unchanged.filter(({ outcome }) => outcome.kind === kind).map(({ promise }) => promise);
    expect(unchanged.filter(({ outcome }) => outcome.kind === "failed")).toEqual([]);
    expect(of("not testable")).toEqual([]);
    const webSocket = connections.checks.filter(({ needs }) => needs?.includes("websocket"));
    expect(of("not offered")).toEqual([
      "pose-heading",
      "pose-axes",
      "pose-ending",
      "maze",
      ...webSocket.map(({ promise }) => promise),
    ]);
    expect(passes(unchanged)).toBe(true);
  });

  it("does the same by WebSocket, where it has one", () => {
    expect(bridged.filter(({ outcome }) => outcome.kind !== "passed")).toEqual([]);
  });

  it.each(plantedFaults)("with a fault, $fault: caught by $caughtBy", (fault) => {
    const found = outcomes.get(fault);
    if (found instanceof Error) throw found;
    // All fields of the failure, so that the report shows which other check failed first.
    expect(found).toEqual({ ...found, promise: fault.caughtBy });
  });

  it("has such a fault for every check", () => {
    const checks = groups.flatMap((group) => group.checks.map(({ promise }) => promise));
    const caught = new Set(plantedFaults.map(({ caughtBy }) => caughtBy));
    expect(checks.filter((promise) => !caught.has(promise))).toEqual([]);
  });
});
