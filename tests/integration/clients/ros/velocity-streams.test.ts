/** Real ROS clients that publish velocities while their network, their relay or another client fails. */
import { monitorEventLoopDelay } from "node:perf_hooks";
import { describe, expect, it, onTestFinished } from "vitest";
import { SeededRandom } from "../../../../apps/relay/src/testing/faults/seeded-random.ts";
import { machineNow, sleep, wallClock } from "../../../../e2e/faults/clock.ts";
import { FaultProxy } from "../../../../e2e/faults/net/fault-proxy.ts";
import { registerRobot } from "../../../../packages/client/src/register-robot.ts";
import { startRelayProcess } from "../../../support/test-relay-process.ts";
import { roslibpyEnvironment } from "../../../support/ros/roslibpy.ts";
import { openSimulatedPage } from "../../../support/client/simulated-page.ts";
import { urlWithKey } from "../../../support/ros/url-with-key.ts";
import { sendWrongMessages } from "../../../support/ros/wrong-messages.ts";
import {
  numberOf,
  streamByRoslib,
  streamByRoslibpy,
} from "../../../support/ros/velocity-streams.ts";

const CUT_MS = 8_000;
/** From the newest velocity on: the lease of 500 ms stops the robot. */
const STANDS_MS = 600;
/** From the cut on. On a slow machine, velocities are under way for longer, but not as long as the cut. */
const STOP_MS = 4_000;
/** roslibpy waits up to 8 s between its first attempts to connect. */
const RECONNECT = { timeout: 60_000, interval: 100 };
/** Velocities published later than this before the end of the cut are not stale. */
const NEW_MS = 1_000;
const AFTER_MS = 2_000;

type Transport = "twisted" | "asyncio";
/** A library: that of JavaScript, or that of Python with a transport. */
type Library = "roslib" | { python: string; transport: Transport };

/** The libraries of a language. */
function librariesOf(name: string, skip: (note: string) => never): Library[] {
  if (name === "roslib") return ["roslib"];
  const found = roslibpyEnvironment();
  if ("missing" in found) return skip(found.missing);
  return (["twisted", "asyncio"] as const).map((transport) => ({ ...found, transport }));
}

/** A robot in its page, and a client that turns it through a proxy. */
async function turningRobot(library: Library) {
  const relay = await startRelayProcess();
  const proxy = await FaultProxy.start({ target: () => relay.port, random: new SeededRandom(1) });
  onTestFinished(() => proxy.close());
  const registration = await registerRobot(relay.url, fetch);
  const robot = openSimulatedPage(relay.url, registration);
  await expect.poll(() => robot.isConnected, RECONNECT).toBe(true);
  const origin = proxy.origin.replace("http", "ws");
  const path = new URL(await urlWithKey(relay.url, registration)).pathname;
  const byHeader = { url: `${origin}/r/${registration.id}/ros`, key: registration.driverKey };
  const stream =
    library === "roslib" ? streamByRoslib(origin + path) : streamByRoslibpy(library, byHeader);
  await expect.poll(() => robot.isMoving && stream.poses > 5, RECONNECT).toBe(true);
  return { relay, proxy, robot, stream, url: relay.url.replace("http", "ws") + path };
}

type Turning = Awaited<ReturnType<typeof turningRobot>>;

/** When the velocities were published that moved the robot from a time on, in ms of `machineNow`. */
async function publishedOf({ relay, robot, stream }: Turning, since: number): Promise<number[]> {
  const records = new Map((await robot.log(relay.url)).map((record) => [record.seq, record]));
  return robot.starts
    .filter(({ at }) => at >= since)
    .map(({ seq }) => {
      const command = records.get(seq)?.command;
      if (command?.action !== "drive") throw new Error(`command ${seq} is no velocity`);
      return (stream.published.get(numberOf(command.right)) ?? 0) - wallClock(0);
    });
}

/** Interrupts the network of a client for 8 s. @returns what moved the robot meanwhile and afterwards */
async function interrupt(turning: Turning, fault: "cut" | "stall") {
  const { proxy, robot } = turning;
  const delays = monitorEventLoopDelay({ resolution: 8 });
  delays.enable();
  const cutAt = machineNow();
  if (fault === "cut") proxy.breakFor(CUT_MS);
  else proxy.stall(CUT_MS);
  await sleep(CUT_MS);
  const { isMoving, movedAt } = robot;
  const backAt = machineNow();
  delays.disable();
  const newestAt = Math.max(cutAt, ...robot.starts.map(({ at }) => at));
  // A page that gets no processor time stops its robot only afterwards.
  const standsMs = movedAt - newestAt - delays.max / 1e6;
  await expect.poll(() => robot.isMoving, RECONNECT).toBe(true);
  await sleep(AFTER_MS);
  const published = await publishedOf(turning, cutAt + STOP_MS);
  const stale = published.filter((at) => at < backAt - NEW_MS).length;
  return { isMoving, standsMs, stopMs: movedAt - cutAt, velocities: published.length, stale };
}

describe.each(["roslib", "roslibpy"])("a robot that %s turns", (name) => {
  it("stands while the network is interrupted, and then is moved by at most one stale value", async ({
    skip,
  }) => {
    const measured = librariesOf(name, skip).flatMap((library) => [
      async () => interrupt(await turningRobot(library), "cut"),
      async () => interrupt(await turningRobot(library), "stall"),
    ]);
    for (const outcome of await Promise.all(measured.map((measure) => measure()))) {
      expect(outcome).toMatchObject({ isMoving: false });
      expect(outcome.standsMs).toBeLessThan(STANDS_MS);
      expect(outcome.stopMs).toBeLessThan(STOP_MS);
      expect(outcome.velocities).toBeGreaterThan(1);
      expect(outcome.stale).toBeLessThanOrEqual(1);
    }
  }, 180_000);

  it("turns again, and reports to the same subscription, after a restart of the relay", async ({
    skip,
  }) => {
    const restart = async ({ relay, robot, stream }: Turning): Promise<void> => {
      await relay.killAndRestart();
      const restartedAt = machineNow();
      const { poses } = stream;
      const isDriven = (): boolean => robot.starts.some(({ at }) => at > restartedAt);
      await expect
        .poll(() => isDriven() && robot.isMoving && stream.poses > poses + 5, RECONNECT)
        .toBe(true);
    };
    const libraries = librariesOf(name, skip);
    const restarts = libraries.map(async (library) => restart(await turningRobot(library)));
    await expect(Promise.all(restarts)).resolves.toHaveLength(libraries.length);
  }, 180_000);

  it("turns on while another client sends 1,000 wrong messages", async ({ skip }) => {
    for (const library of librariesOf(name, skip)) {
      const { proxy, stream, url } = await turningRobot(library);
      const connectedAt = proxy.answeredAt;
      await sendWrongMessages(url);
      const { poses } = stream;
      await expect.poll(() => stream.poses > poses + 5, RECONNECT).toBe(true);
      expect(proxy.answeredAt).toBe(connectedAt);
    }
  }, 180_000);
});
