/** The JavaScript library of ROS, unchanged, in a page of another site. */
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright";
import { build } from "rolldown";
import type { Action, Ros, Service, Topic } from "roslib";
import { beforeAll, expect, it, onTestFinished } from "vitest";
import { chromiumArguments, requireHeadlessChromium } from "../../../../scripts/chromium.ts";
import { registerRobot } from "../../../../packages/client/src/register-robot.ts";
import { openSimulatedPage } from "../../../support/client/simulated-page.ts";
import { corridor, corridorHost } from "../../../support/mcp/corridor-host.ts";
import { urlWithKey } from "../../../support/ros/url-with-key.ts";
import { sendWrongMessages } from "../../../support/ros/wrong-messages.ts";
import { startRelayProcess } from "../../../support/test-relay-process.ts";

declare const ROSLIB: {
  Action: typeof Action;
  Ros: typeof Ros;
  Service: typeof Service;
  Topic: typeof Topic;
};

const SLOW = { timeout: 20_000 };

let library = "";

beforeAll(async () => {
  const { output } = await build({
    input: fileURLToPath(import.meta.resolve("roslib")),
    platform: "browser",
    output: { format: "iife", name: "ROSLIB", codeSplitting: false },
    logLevel: "silent",
    write: false,
  });
  library = output[0].code;
});

/** Opens a page of a site that contains only the library. */
async function pageOfAnotherSite() {
  const site = createServer((request, response) => {
    const isScript = request.url === "/roslib.js";
    response.setHeader("Content-Type", isScript ? "text/javascript" : "text/html");
    response.end(isScript ? library : '<!doctype html><script src="/roslib.js"></script>');
  });
  await new Promise<void>((resolve) => void site.listen(0, "127.0.0.1", resolve));
  const browser = await chromium.launch({
    executablePath: requireHeadlessChromium(),
    args: [...chromiumArguments],
  });
  onTestFinished(async () => {
    await browser.close();
    site.close();
  });
  const page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${(site.address() as AddressInfo).port}/`);
  return page;
}

it.each(["the first message", "the path"])(
  "reads, drives, stops and resets by a key in %s",
  async (where) => {
    const { relay, registration, page } = await corridorHost(await startRelayProcess());
    const isInPath = where === "the path";
    const url = isInPath
      ? await urlWithKey(relay.url, registration)
      : `${relay.url.replace("http", "ws")}/r/${registration.id}/ros`;
    const key = isInPath ? null : registration.driverKey;
    const site = await pageOfAnotherSite();
    const received = await site.evaluate(
      async (given) => {
        const ros = new ROSLIB.Ros({ url: given.url });
        if (given.key !== null) ros.authenticate(given.key, "", "", "", 0, "", 0);
        const first = async (name: string, messageType: string): Promise<unknown> =>
          new Promise((resolve) => new ROSLIB.Topic({ ros, name, messageType }).subscribe(resolve));
        const odom = await first("/odom", "nav_msgs/Odometry");
        const scan = await first("/scan", "sensor_msgs/LaserScan");
        const name = "/cmd_vel";
        const topic = new ROSLIB.Topic({ ros, name, messageType: "geometry_msgs/Twist" });
        const drive = (x: number): void =>
          topic.publish({ linear: { x, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0 } });
        const call = async (service: string): Promise<unknown> =>
          new Promise((resolve, reject) => {
            const serviceType = "std_srvs/Trigger";
            new ROSLIB.Service({ ros, name: service, serviceType }).callService(
              {},
              resolve,
              reject,
            );
          });
        Object.assign(window, { drive, call });
        return { origin, odom, scan };
      },
      { url, key },
    );
    expect(received.origin).not.toBe(new URL(relay.url).origin);
    expect(received).toMatchObject({
      odom: { pose: { pose: { position: { x: 1.5, y: 5.5, z: 0 } } } },
      scan: { ranges: [0.5, 0.5, 4.5, 0.5] },
    });
    await site.evaluate("drive(0.261)");
    const power = { action: "drive", left: 0.1, right: 0.1 };
    await expect.poll(() => page.robot.done, SLOW).toMatchObject([power]);
    await site.evaluate("drive(0)");
    const none = { action: "drive", left: 0, right: 0 };
    await expect.poll(() => page.robot.done, SLOW).toMatchObject([power, none]);
    expect(await site.evaluate("call('/reset')")).toMatchObject({ success: true });
  },
);

it("follows and cancels a goal, and reads topics, types and the time", async () => {
  const relay = await startRelayProcess();
  const registration = await registerRobot(relay.url, fetch);
  const robot = openSimulatedPage(relay.url, registration, corridor);
  await expect.poll(() => robot.isConnected, SLOW).toBe(true);
  const site = await pageOfAnotherSite();
  const received = await site.evaluate(
    async (url) => {
      const ros = new ROSLIB.Ros({ url });
      const actionType = "corridor_msgs/action/Move";
      const action = new ROSLIB.Action({ ros, name: "/move", actionType });
      const move = async (distance: number, isCancelled: boolean) => {
        const feedback: unknown[] = [];
        const ended = Promise.withResolvers<unknown>();
        const id = action.sendGoal(
          { distance },
          ended.resolve,
          (message) => {
            feedback.push(message);
            if (isCancelled) action.cancelGoal(String(id));
          },
          ended.resolve,
        );
        return { end: await ended.promise, feedback };
      };
      const topics = await new Promise<{ topics: string[]; types: string[] }>((resolve, reject) => {
        ros.getTopics(resolve, reject);
      });
      const get = new ROSLIB.Service({
        ros,
        name: "/rosapi/get_time",
        serviceType: "rosapi/GetTime",
      });
      const time = await new Promise((resolve, reject) => {
        get.callService({}, resolve, reject);
      });
      const completed = await move(0.5, false);
      const cancelled = await move(3, true);
      return { topics, time, completed, cancelled };
    },
    await urlWithKey(relay.url, registration),
  );
  const { topics, types } = received.topics;
  expect(types[topics.indexOf("/odom")]).toBe("nav_msgs/msg/Odometry");
  const place = { distance: expect.any(Number), x: expect.any(Number), y: -1.5, theta: 0 };
  expect(received).toMatchObject({
    time: { time: { sec: expect.any(Number), secs: expect.any(Number) } },
    completed: { end: { state: "completed", distance: expect.closeTo(0.5) } },
    // The library reports every status but 4 as a failure, with the result as JSON.
    cancelled: { end: expect.stringContaining('"state":"cancelled"') },
  });
  expect(received.completed.feedback).toContainEqual(place);
  expect(received.cancelled.feedback).toContainEqual(place);
});

it("reads on while another client sends 1,000 wrong messages, and after a restart of the relay", async () => {
  const relay = await startRelayProcess();
  const registration = await registerRobot(relay.url, fetch);
  const robot = openSimulatedPage(relay.url, registration, corridor);
  await expect.poll(() => robot.isConnected, SLOW).toBe(true);
  const url = await urlWithKey(relay.url, registration);
  const site = await pageOfAnotherSite();
  await site.evaluate((given) => {
    const seen = { poses: 0, connections: 0 };
    const ros = new ROSLIB.Ros({ url: given });
    ros.on("error", () => undefined);
    ros.on("connection", () => (seen.connections += 1));
    // It does not reconnect by itself: programs do as its documentation shows.
    ros.on("close", () => setTimeout(() => void ros.connect(given).catch(() => undefined), 250));
    new ROSLIB.Topic({ ros, name: "/pose2d", messageType: "geometry_msgs/Pose2D" }).subscribe(
      () => (seen.poses += 1),
    );
    const velocity = new ROSLIB.Topic({
      ros,
      name: "/cmd_vel",
      messageType: "geometry_msgs/Twist",
    });
    const left = { linear: { x: 0, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 1 } };
    setInterval(() => velocity.publish(left), 100);
    Object.assign(window, { seen });
  }, url);
  const seen = async () => site.evaluate("seen") as Promise<{ poses: number; connections: number }>;
  const readsOn = async (): Promise<void> => {
    const { poses } = await seen();
    const morePoses = async () => (await seen()).poses > poses + 5;
    await expect.poll(async () => robot.isMoving && (await morePoses()), SLOW).toBe(true);
  };
  await readsOn();
  await sendWrongMessages(url);
  await readsOn();
  expect((await seen()).connections).toBe(1);
  await relay.killAndRestart();
  await readsOn();
  expect((await seen()).connections).toBeGreaterThan(1);
}, 120_000);
