/** One script with roslibpy, by `corridor ros`: with a robot at a relay and a physical one. */
import { execFile } from "node:child_process";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { describe, expect, it, onTestFinished } from "vitest";
import { BridgeProcess } from "../../../support/bridges/bridge-process.ts";
import { PEN, startPhysicalRobot } from "../../../support/conformance/physical-robot.ts";
import { corridorHost } from "../../../support/mcp/corridor-host.ts";
import { roslibpyEnvironment } from "../../../support/ros/roslibpy.ts";
import { startRelayProcess } from "../../../support/test-relay-process.ts";

const run = promisify(execFile);
const SCRIPT = fileURLToPath(new URL("../../../support/ros/roslibpy_port.py", import.meta.url));
const TIMEOUT_MS = 300_000;

interface Received {
  topics: string[];
  before: number[];
  move: object;
  turns: number[];
  after: number[];
  stop: object;
  driven: number[];
}

/** Back, right, front, left: the order of the beams. */
const FRONT = 2;

async function drive(python: string, address: string): Promise<Received> {
  const { bridge, url } = await BridgeProcess.startRos(address);
  const { stdout } = await run(python, [SCRIPT, new URL(url).port]).catch((error: unknown) => {
    throw new Error(`${String(error)}\n${bridge.output.stderr}`);
  });
  return JSON.parse(stdout) as Received;
}

describe("a script with roslibpy that knows only a host and a port", () => {
  it("drives a robot at a relay", { timeout: TIMEOUT_MS }, async ({ skip }) => {
    const found = roslibpyEnvironment();
    if ("missing" in found) return skip(found.missing);
    const { relay, page, registration } = await corridorHost(await startRelayProcess());
    const address = `${relay.url}/r/${registration.id}#${registration.driverKey}`;
    const received = await drive(found.python, address);
    expect(received).toMatchObject({
      topics: expect.arrayContaining(["/odom", "/cmd_vel"]),
      before: [0.5, 0.5, 4.5, 0.5],
      move: { values: { state: "completed", distance: 1 }, status: 4 },
      after: [1.5, 0.5, 3.5, 0.5],
      stop: { success: true },
    });
    const drives = page.robot.done.filter(({ action }) => action === "drive");
    expect(drives[0]).toMatchObject({ left: 0.5 / 2.61, right: 0.5 / 2.61 });
  });

  it("drives a physical robot, unchanged", { timeout: TIMEOUT_MS }, async ({ skip }) => {
    const found = roslibpyEnvironment();
    if ("missing" in found) return skip(found.missing);
    const { address, stop } = await startPhysicalRobot({ room: PEN });
    onTestFinished(() => stop());
    const { topics, before, move, turns, after, driven, ...others } = await drive(
      found.python,
      address,
    );
    expect(topics).toEqual(expect.arrayContaining(["/odom", "/cmd_vel"]));
    expect(move).toMatchObject({ values: { state: "completed" }, status: 4 });
    expect(turns).toEqual([4, 4, 4, 4]);
    expect((before[FRONT] ?? 0) - (after[FRONT] ?? 0)).toBeCloseTo(1, 1);
    expect(driven[FRONT]).toBeLessThan((after[FRONT] ?? 0) - 0.1);
    expect(others).toEqual({ stop: { success: true, message: expect.any(String) } });
  });
});
