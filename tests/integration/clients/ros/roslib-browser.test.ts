/** The JavaScript library of ROS, unchanged, in a page of another site. */
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright";
import { build } from "rolldown";
import type { Ros, Service, Topic } from "roslib";
import { beforeAll, expect, it, onTestFinished } from "vitest";
import { chromiumArguments, requireHeadlessChromium } from "../../../../scripts/chromium.ts";
import { corridorHost } from "../../../support/mcp/corridor-host.ts";
import { urlWithKey } from "../../../support/ros/url-with-key.ts";
import { startRelayProcess } from "../../../support/test-relay-process.ts";

declare const ROSLIB: { Ros: typeof Ros; Service: typeof Service; Topic: typeof Topic };

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
