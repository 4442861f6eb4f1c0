/** `corridor ros` in its own process, with a robot at a real relay. */
import { once } from "node:events";
import { createServer, type AddressInfo } from "node:net";
import { scriptListSchema, type Registration } from "@corridor/protocol";
import { describe, expect, it, onTestFinished } from "vitest";
import { RosClient } from "../../../../apps/relay/src/testing/ros-client.ts";
import { BridgeProcess } from "../../../support/bridges/bridge-process.ts";
import { startFilterProxy } from "../../../support/client/start-filter-proxy.ts";
import { corridorHost } from "../../../support/mcp/corridor-host.ts";
import type { RelayProcess } from "../../../support/relay-process.ts";
import { sharedRelayProcess, startRelayProcess } from "../../../support/test-relay-process.ts";

const addressOf = (origin: string, { id, driverKey }: Registration): string =>
  `${origin}/r/${id}#${driverKey}`;

const sharedRelay = sharedRelayProcess();

async function bridgedRobot(own?: RelayProcess) {
  const host = await corridorHost(own ?? (await sharedRelay()));
  const address = addressOf(host.relay.url, host.registration);
  return { ...host, address, ...(await BridgeProcess.startRos(address)) };
}

async function ask(
  { relay, registration }: { relay: { url: string }; registration: Registration },
  method: string,
  path: string,
  body?: object,
): Promise<Response> {
  return fetch(`${relay.url}/api/v1/robots/${registration.id}${path}`, {
    method,
    headers: {
      Authorization: `Bearer ${registration.ownerKey}`,
      "Content-Type": "application/json",
    },
    ...(body !== undefined && { body: JSON.stringify(body) }),
  });
}

const velocity = (x: number): object => ({
  op: "publish",
  topic: "/cmd_vel",
  msg: { linear: { x } },
});
const goal = (action: string, args: object): object => ({
  op: "send_action_goal",
  id: "goal",
  action,
  args,
});

describe("corridor ros", () => {
  it("serves ROS clients by host and port, and the owner sees a script named ROS", async () => {
    const host = await bridgedRobot();
    const client = await RosClient.open(host.url);
    client.send({ op: "subscribe", topic: "/pose2d" });
    expect(await client.next("topic", "/pose2d")).toMatchObject({
      msg: { x: 1.5, y: 5.5, theta: 0 },
    });
    client.send(goal("/move", { distance: 1 }));
    expect(await client.next("op", "action_result")).toMatchObject({
      status: 4,
      values: { state: "completed", x: 2.5 },
    });
    client.send(velocity(0.261));
    await expect
      .poll(() => host.page.robot.done.at(-1))
      .toMatchObject({ action: "drive", left: 0.1, right: 0.1 });
    const { scripts } = scriptListSchema.parse(await (await ask(host, "GET", "/scripts")).json());
    expect(scripts).toMatchObject([{ client: "ROS", name: null, connections: 1 }]);
  });

  it("drives by the binary messages that ROS# sends", async () => {
    const { url, page } = await bridgedRobot();
    const client = await RosClient.open(url);
    client.sendText(Buffer.from(JSON.stringify(goal("/move", { distance: 1 }))), true);
    expect(await client.next("op", "action_result")).toMatchObject({ status: 4 });
    expect(page.robot.done).toMatchObject([{ action: "move", distance: 100 }]);
  });

  it("refuses pages of other sites, and accepts those of this computer", async () => {
    const { url } = await bridgedRobot();
    await expect(RosClient.open(url, { Origin: "https://elsewhere.example" })).rejects.toThrow(
      "403",
    );
    await expect(RosClient.open(url, { Origin: "null" })).rejects.toThrow("403");
    const client = await RosClient.open(url, { Origin: "http://localhost:5173" });
    expect(await client.call("rosapi/get_ros_version")).toMatchObject({ result: true });
  });

  it("ends its motions on Ctrl+C, and exits with 0", async () => {
    const { url, bridge, page } = await bridgedRobot();
    page.endsCommands = false;
    const client = await RosClient.open(url);
    client.send(goal("/move", { distance: 3 }));
    await expect.poll(() => page.running).toBe(1);
    bridge.signal("SIGINT");
    await expect.poll(() => page.running).toBe(0);
    expect(await bridge.exited).toBe(0);
    expect(await client.closed).toMatchObject({ code: 1001 });
  });

  it("drives by a single velocity whose client disconnects at once", async () => {
    const { url, page } = await bridgedRobot();
    const driver = await RosClient.open(url);
    driver.send(velocity(0.261));
    driver.close();
    await driver.closed;
    await expect
      .poll(() => page.robot.done)
      .toMatchObject([{ action: "drive", left: 0.1, right: 0.1 }]);
  });

  it("ends a motion without an end when its client disconnects", async () => {
    const { url, page } = await bridgedRobot();
    page.endsCommands = false;
    const driver = await RosClient.open(url);
    driver.send(goal("/do", { action: "forward" }));
    await expect.poll(() => page.running).toBe(1);
    driver.close();
    await driver.closed;
    await expect.poll(() => page.running).toBe(0);
  });

  it("closes its clients and exits when the key is revoked", async () => {
    const host = await bridgedRobot();
    const client = await RosClient.open(host.url);
    await client.call("rosapi/get_time");
    await ask(host, "POST", "/keys", { kind: "drive", replace: true });
    expect(await client.closed).toMatchObject({
      code: 4401,
      reason: expect.stringContaining("The key is invalid or was revoked."),
    });
    expect(await host.bridge.exited).toBe(1);
    expect(host.bridge.output.stderr).toContain("The key is invalid or was revoked.");
  });

  it("keeps its clients while the relay restarts", { timeout: 120_000 }, async () => {
    const { relay, url, page } = await bridgedRobot(await startRelayProcess());
    const client = await RosClient.open(url);
    client.send(goal("/move", { distance: 1 }));
    await client.next("op", "action_result");
    await relay.killAndRestart();
    client.send(goal("/move", { distance: 1 }));
    expect(await client.next("op", "action_result")).toMatchObject({ status: 4 });
    expect(page.robot.done).toHaveLength(2);
  });

  it("falls back to HTTPS behind a filter that blocks WebSockets", async () => {
    const { relay, registration, page } = await corridorHost(await sharedRelay());
    const proxy = await startFilterProxy(relay.url, "blocked");
    const { url } = await BridgeProcess.startRos(addressOf(proxy.origin, registration));
    const client = await RosClient.open(url);
    client.send(goal("/turn", { angle: Math.PI / 2 }));
    expect(await client.next("op", "action_result")).toMatchObject({ status: 4 });
    expect(page.robot.done).toMatchObject([{ action: "turn", degrees: -90 }]);
    expect(proxy.upgrades).toBe(0);
  });

  it("prints no key", async () => {
    const { address, registration, bridge, url } = await bridgedRobot();
    const client = await RosClient.open(url);
    client.send({ op: "subscribe", topic: "/nothing" });
    await bridge.says(/does not publish \/nothing/);
    const second = BridgeProcess.launch(["ros", address, "--port", new URL(url).port]);
    expect(await second.exited).toBe(1);
    expect(second.output.stderr).toMatch(/^Port \d+ is in use\. .*--port\.\n$/);
    const wrong = BridgeProcess.launch(["ros", address.replace("drv_", "drv_x")]);
    expect(await wrong.exited).toBe(1);
    expect(wrong.output.stderr).toContain("The robot rejects this key (not-authorised).");
    const invalid = BridgeProcess.launch(["ros", address, "--address", address]);
    expect(await invalid.exited).toBe(2);
    for (const each of [bridge, second, wrong, invalid]) {
      expect(JSON.stringify(each.output)).not.toContain(registration.driverKey.slice(4));
    }
  });

  it("reports at once that the host does not respond, and stops on Ctrl+C", async () => {
    const server = createServer();
    await once(server.listen(0, "127.0.0.1"), "listening");
    const { port } = server.address() as AddressInfo;
    onTestFinished(() => void server.close());
    const address = `http://127.0.0.1:${port}/r/${"a".repeat(22)}#drv_${"b".repeat(22)}`;
    server.close();
    const bridge = BridgeProcess.launch(["ros", address, "--port", "0"]);
    await bridge.says(/does not respond at http:\/\/127\.0\.0\.1:\d+\. Retrying\./);
    bridge.signal("SIGINT");
    expect(await bridge.exited).toBe(0);
  });
});
