/**
 * The example of a physical robot passes all checks. For each check, a copy with an injected fault
 * fails this check first.
 */
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { connections } from "./checks/connections.ts";
import { passes } from "./report.ts";
import { groups, runChecks, type Outcome, type Result, type RunOptions } from "./run-checks.ts";
import type { InjectedFault } from "./testing/injected-fault.ts";
import { injectedFaults } from "./testing/injected-faults.ts";
import {
  PEN,
  startPhysicalRobot,
  type RobotOptions,
  type RunningRobot,
} from "./testing/physical-robot.ts";
import { startBridge, type BridgeFault } from "./testing/websocket-bridge.ts";

/** Robots that run concurrently. A run mostly waits for leases and ttls. */
const CONCURRENCY = 24;
/** Timeout for all runs, in ms. */
const RUN_MS = 600_000;

/** Promises that no run can test, so that no fault is injected. */
const NEVER_TESTABLE = ["state-change", "events-time"];

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

async function firstFailure({ edits, bridge }: InjectedFault): Promise<Result | undefined> {
  const results =
    bridge === undefined
      ? await kitOn({ isTracked: true, edits }, { stopsAtFailure: true })
      : await connectionsOn(bridge);
  return results.find(({ outcome }) => outcome.kind === "failed");
}

/**
 * Runs the checks of connections with a WebSocket bridge; the bridge does not affect other checks.
 */
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
  const outcomes = new Map<InjectedFault, Result | undefined | Error>();
  let unchanged: Result[] = [];
  let bridged: Result[] = [];

  beforeAll(async () => {
    // The longest runs start first: those of the last checks.
    const rest = [...injectedFaults];
    const work = Array.from({ length: CONCURRENCY }, async () => {
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

  it("passes all checks, and reports the features that it does not offer", () => {
    const of = (kind: Outcome["kind"]) =>
      unchanged.filter(({ outcome }) => outcome.kind === kind).map(({ promise }) => promise);
    expect(unchanged.filter(({ outcome }) => outcome.kind === "failed")).toEqual([]);
    expect(of("not testable")).toEqual(NEVER_TESTABLE);
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

  it("passes the checks of connections with a WebSocket", () => {
    expect(bridged.filter(({ outcome }) => outcome.kind !== "passed")).toEqual([]);
  });

  it.each(injectedFaults)("with a fault, $fault: caught by $caughtBy", (fault) => {
    const found = outcomes.get(fault);
    if (found instanceof Error) throw found;
    // All fields of the failure, so that the report shows which other check failed first.
    expect(found).toEqual({ ...found, promise: fault.caughtBy });
  });

  it("has an injected fault for every check", () => {
    const checks = groups.flatMap((group) => group.checks.map(({ promise }) => promise));
    const caught = new Set(injectedFaults.map(({ caughtBy }) => caughtBy));
    expect(checks.filter((promise) => !caught.has(promise))).toEqual(NEVER_TESTABLE);
  });
});
