/** The ROS library of Python drives a robot through a real relay. */
import { execFile } from "node:child_process";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { describe, expect, it } from "vitest";
import { registerRobot } from "../../../../packages/client/src/register-robot.ts";
import { openSimulatedPage } from "../../../support/client/simulated-page.ts";
import { corridor, corridorHost } from "../../../support/mcp/corridor-host.ts";
import { roslibpyEnvironment } from "../../../support/ros/roslibpy.ts";
import { urlWithKey } from "../../../support/ros/url-with-key.ts";
import { sharedRelayProcess } from "../../../support/test-relay-process.ts";

const run = promisify(execFile);
const support = (name: string): string =>
  fileURLToPath(new URL(`../../../support/ros/${name}`, import.meta.url));

const sharedRelay = sharedRelayProcess();

describe("roslibpy", () => {
  it.for(["twisted", "asyncio"])(
    "connects by each kind of key, reads, drives and resets (%s)",
    { timeout: 300_000 },
    async (transport, { skip }) => {
      const { relay, page, registration } = await corridorHost(await sharedRelay());
      const found = roslibpyEnvironment();
      if ("missing" in found) return skip(found.missing);
      const withKey = await urlWithKey(relay.url, registration);
      const url = `${relay.url.replace("http", "ws")}/r/${registration.id}/ros`;
      const { stdout } = await run(
        found.python,
        [support("roslibpy_client.py"), url, registration.driverKey, withKey],
        { env: { ...process.env, ROSLIBPY_TRANSPORT: transport } },
      ).catch((error: unknown) => {
        throw new Error(`${String(error)}\n${relay.log}`);
      });
      const received = JSON.parse(stdout) as Record<string, unknown>;
      expect(received).toMatchObject({
        position: { x: 1.5, y: 5.5, z: 0 },
        ranges: [0.5, 0.5, 4.5, 0.5],
        pose: { x: 1.5, y: 5.5, theta: 0 },
        topics: expect.arrayContaining(["/odom", "/cmd_vel"]),
        type: "nav_msgs/msg/Odometry",
        time: expect.any(Number),
        move: { values: { state: "completed", distance: 1, x: 2.5, y: 5.5 }, status: 4 },
        crash: { values: { state: "collided" }, status: 6 },
        wrong: { values: expect.stringContaining("action: expected one of"), status: 0 },
        reset: { success: true },
        stop: { success: true },
      });
      const drives = page.robot.done.filter(({ action }) => action === "drive");
      expect(drives[0]).toMatchObject({ left: 0.5 / 2.61, right: 0.5 / 2.61 });
    },
  );

  it.for(["twisted", "asyncio"])(
    "receives feedback, cancels a goal, and stops by a velocity of 0 (%s)",
    { timeout: 300_000 },
    async (transport, { skip }) => {
      const found = roslibpyEnvironment();
      if ("missing" in found) return skip(found.missing);
      const relay = await sharedRelay();
      const registration = await registerRobot(relay.url, fetch);
      const robot = openSimulatedPage(relay.url, registration, corridor);
      await expect.poll(() => robot.isConnected, { timeout: 30_000 }).toBe(true);
      const url = `${relay.url.replace("http", "ws")}/r/${registration.id}/ros`;
      const { stdout } = await run(
        found.python,
        [support("roslibpy_goals.py"), url, registration.driverKey],
        { env: { ...process.env, ROSLIBPY_TRANSPORT: transport } },
      ).catch((error: unknown) => {
        throw new Error(`${String(error)}\n${relay.log}`);
      });
      expect(JSON.parse(stdout)).toMatchObject({
        feedback: expect.arrayContaining([
          { distance: expect.any(Number), x: expect.any(Number), y: -1.5, theta: 0 },
        ]),
        completed: { values: { state: "completed", distance: expect.closeTo(0.5) }, status: 4 },
        cancelled: { values: { state: "cancelled", y: -1.5 }, status: 5 },
        time: { secs: expect.any(Number), nsecs: expect.any(Number) },
      });
      await expect.poll(() => robot.isMoving, { timeout: 30_000 }).toBe(false);
      const velocities = (await robot.log(relay.url)).filter(({ action }) => action === "drive");
      const power = { action: "drive", left: -0.1, right: -0.1 };
      expect(velocities.at(0)?.command).toMatchObject(power);
      expect(velocities.at(-1)?.command).toMatchObject({ action: "drive", left: 0, right: 0 });
    },
  );
});
