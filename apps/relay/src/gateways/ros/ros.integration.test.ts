import type { Registration, ScriptList } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { pino } from "pino";
import { describe, expect, it, vi } from "vitest";
import { makeKey, reportedRobot } from "../../testing/reported-robot.ts";
import { RosClient } from "../../testing/ros-client.ts";
import { startTestRelay, type TestRelay } from "../../testing/test-relay.ts";
import { TestSocket } from "../../testing/test-socket.ts";

async function rosScript(relay: TestRelay, robot: Registration) {
  const answer = await relay.ask(robot, "/scripts", { key: robot.ownerKey });
  const { scripts } = (await answer.json()) as ScriptList;
  return scripts.find(({ client }) => client === "ROS");
}

const subscribe = { op: "subscribe", id: "s", topic: "/pose2d" };
const move = { op: "send_action_goal", id: "goal", action: "/move", args: { distance: 1 } };

describe("a ROS client", () => {
  it("connects with a key in the header, in auth or in the path", async () => {
    const { relay, robot } = await reportedRobot();
    const { key } = await makeKey(relay, robot, "drive", "url");
    const byHeader = await RosClient.connect(relay, robot);
    const byPath = await RosClient.connect(relay, robot, { pathKey: key });
    const byAuth = await RosClient.connect(relay, robot, { key: null });
    byAuth.send(subscribe);
    byAuth.send({ op: "auth", mac: robot.driverKey, client: "", dest: "", rand: "", t: 0 });
    for (const client of [byHeader, byPath]) client.send(subscribe);
    for (const client of [byHeader, byPath, byAuth]) {
      expect(await client.next("topic", "/pose2d")).toMatchObject({ op: "publish" });
    }
  });

  it("drives by the key of its first message, although the key in the path only reads", async () => {
    const { relay, robot, page } = await reportedRobot();
    const { key } = await makeKey(relay, robot, "watch", "url");
    const client = await RosClient.connect(relay, robot, { pathKey: key });
    client.send({ op: "auth", mac: robot.driverKey, client: "", dest: "", rand: "", t: 0 });
    client.send(subscribe);
    client.send({ op: "publish", topic: "/cmd_vel", msg: { linear: { x: 0.261 } } });
    await client.next("topic", "/pose2d");
    expect((await page.next("command"))["command"]).toMatchObject({ action: "drive", left: 0.1 });
  });

  it("is closed if its first message has a wrong key, whatever the path permits", async () => {
    const { relay, robot } = await reportedRobot();
    const { key } = await makeKey(relay, robot, "drive", "url");
    const client = await RosClient.connect(relay, robot, { pathKey: key });
    client.send({ op: "auth", mac: key });
    expect((await client.closed).code).toBe(4401);
  });

  it("keeps its key if `auth` is not the first message, or the header has one", async () => {
    const { relay, robot } = await reportedRobot();
    const { key } = await makeKey(relay, robot, "drive", "url");
    const byPath = await RosClient.connect(relay, robot, { pathKey: key });
    await byPath.call("rosapi/nodes");
    const byHeader = await RosClient.connect(relay, robot);
    for (const client of [byPath, byHeader]) {
      client.send({ op: "auth", mac: "wrong" });
      expect(await client.call("/rosapi/get_time")).toMatchObject({ result: true });
    }
  });

  it("connects by a URL with a slash at its end, with or without a key in the path", async () => {
    const { relay, robot } = await reportedRobot();
    const { key } = await makeKey(relay, robot, "drive", "url");
    const url = `${relay.origin.replace("http", "ws")}/r/${robot.id}/ros/`;
    const byPath = await RosClient.open(`${url}${key}/`);
    const byHeader = await RosClient.open(url, { Authorization: `Bearer ${robot.driverKey}` });
    for (const client of [byPath, byHeader]) {
      expect(await client.call("rosapi/nodes")).toMatchObject({ result: true });
    }
  });

  it("is answered in text if it sends binary messages, as ROS# does", async () => {
    const { relay, robot } = await reportedRobot();
    const client = await RosClient.connect(relay, robot);
    client.sendText(Buffer.from(JSON.stringify(subscribe)), true);
    expect(await client.next("topic", "/pose2d")).toMatchObject({ op: "publish" });
  });

  it("connects from a page of another site", async () => {
    const { relay, robot } = await reportedRobot();
    const headers = { Origin: "https://elsewhere.example" };
    const client = await RosClient.connect(relay, robot, { headers });
    expect(await client.call("rosapi/get_ros_version")).toMatchObject({ result: true });
  });

  it("drives, and sends a goal whose result it receives", async () => {
    const { relay, robot, page, start, end } = await reportedRobot();
    const client = await RosClient.connect(relay, robot);
    client.send({ op: "publish", topic: "/cmd_vel", msg: { linear: { x: 0.261 } } });
    const { command } = await page.next("command");
    expect(command).toMatchObject({ action: "drive", left: 0.1, right: 0.1 });
    client.send(move);
    const seq = await start();
    end(seq);
    expect(await client.next("op", "action_result")).toMatchObject({
      id: "goal",
      action: "/move",
      status: 4,
      result: true,
      values: { state: "completed" },
    });
  });

  it("reads on /rosout why a velocity moved nothing", async () => {
    const { relay, robot, page, epoch } = await reportedRobot();
    const client = await RosClient.connect(relay, robot);
    client.send({ op: "subscribe", topic: "/rosout" });
    client.send({ op: "publish", topic: "/cmd_vel", msg: { linear: { x: 0.261 } } });
    const { seq } = await page.next("command");
    const reason = "Remote is not driving: choose Remote on the robot's page.";
    const ending = { state: "cancelled", reason, pose: null, distance: null };
    page.send({ type: "ended", epoch, seq, ...ending });
    expect((await client.next("topic", "/rosout"))["msg"]).toMatchObject({ msg: reason });
  });

  it("drives by a single message, although it disconnects at once", async () => {
    const { relay, robot, page } = await reportedRobot();
    const client = await RosClient.connect(relay, robot);
    client.send({ op: "publish", topic: "/cmd_vel", msg: { linear: { x: 0.261 } } });
    client.close();
    const { command, lease } = await page.next("command");
    expect({ command, lease }).toMatchObject({
      command: { action: "drive", left: 0.1 },
      lease: 500,
    });
  });

  it("is in the owner's list as ROS, with the reason of the newest refused message", async () => {
    const { relay, robot } = await reportedRobot();
    const client = await RosClient.connect(relay, robot);
    client.send({ op: "publish", topic: "/fly", msg: {} });
    await vi.waitFor(async () => {
      const script = await rosScript(relay, robot);
      expect(script).toMatchObject({
        connections: 1,
        lastProblem: { detail: "The robot does not subscribe to /fly, only to /cmd_vel." },
      });
    });
  });

  it("with a watch key reads, and does not drive", async () => {
    const { relay, robot } = await reportedRobot();
    const { key } = await makeKey(relay, robot, "watch", "url");
    const client = await RosClient.connect(relay, robot, { pathKey: key });
    client.send(subscribe);
    await client.next("topic", "/pose2d");
    client.send({ op: "subscribe", topic: "/rosout" });
    client.send({ op: "publish", topic: "/cmd_vel", msg: { linear: { x: 1 } } });
    expect((await client.next("topic", "/rosout"))["msg"]).toMatchObject({
      msg: expect.stringContaining("A watch key permits only reading."),
    });
    expect(await client.call("/stop")).toMatchObject({ result: false });
    client.send(move);
    expect(await client.next("op", "action_result")).toMatchObject({ result: false, status: 0 });
  });
});

describe("a connection without a valid key", () => {
  it("is refused before it opens", async () => {
    const { relay, robot } = await reportedRobot();
    const other = await relay.register();
    const url = (await makeKey(relay, robot, "drive", "url")).key;
    const refused = (options: Parameters<typeof RosClient.connect>[2]): Promise<number> =>
      RosClient.refusedWith(relay, robot, options);
    expect(await refused({ key: other.driverKey })).toBe(401);
    expect(await refused({ key: url })).toBe(401);
    expect(await refused({ pathKey: robot.driverKey })).toBe(401);
    expect(await refused({ key: robot.ownerKey })).toBe(403);
    expect(await RosClient.refusedWith(relay, { ...robot, id: "AAAAAAAAAA" })).toBe(404);
  });

  it("closes after 32 messages, or 2 s", async () => {
    const { relay, robot } = await reportedRobot();
    const loud = await RosClient.connect(relay, robot, { key: null });
    const silent = await RosClient.connect(relay, robot, { key: null });
    const wrong = await RosClient.connect(relay, robot, { key: null });
    for (let i = 0; i < 33; i += 1) loud.send(subscribe);
    wrong.send({ op: "auth", mac: `drv_${"A".repeat(22)}` });
    for (const client of [loud, wrong, silent]) expect((await client.closed).code).toBe(4401);
  });
});

describe("the owner of the robot", () => {
  it("pauses, blocks and revokes a ROS client", async () => {
    const { relay, robot, page } = await reportedRobot();
    const { id, key } = await makeKey(relay, robot, "drive");
    const own = { key: robot.ownerKey };
    const client = await RosClient.connect(relay, robot, { key });
    await client.call("rosapi/nodes");
    await relay.ask(robot, "/pause", { ...own, method: "PUT" });
    client.send(move);
    expect(await client.next("op", "action_result")).toMatchObject({ result: false });
    await relay.ask(robot, "/pause", { ...own, method: "DELETE" });
    client.send(move);
    await page.next("command");
    const { driver, name, client: language } = (await rosScript(relay, robot)) ?? {};
    const body = { driver, name, client: language };
    const answer = await relay.ask(robot, "/blocked", { ...own, method: "POST", body });
    expect((await client.closed).code).toBe(4403);
    expect(await RosClient.refusedWith(relay, robot, { key })).toBe(403);
    const blocked = (await answer.json()) as { id: string };
    await relay.ask(robot, `/blocked/${blocked.id}`, { ...own, method: "DELETE" });
    const again = await RosClient.connect(relay, robot, { key });
    await again.call("rosapi/nodes");
    await relay.ask(robot, `/keys/${id}`, { ...own, method: "DELETE" });
    expect((await again.closed).code).toBe(4401);
  });

  it("makes a key for a URL of ROS clients", async () => {
    const { relay, robot } = await reportedRobot();
    const body = { kind: "drive", use: "url" };
    const made = await relay.ask(robot, "/keys", { method: "POST", key: robot.ownerKey, body });
    const { key, urls } = (await made.json()) as { key: string; urls: { ros: string } };
    expect(urls.ros).toBe(`${relay.origin.replace("http", "ws")}/r/${robot.id}/ros/${key}`);
  });
});

describe("limits", () => {
  it("close a connection after 10 unreadable messages, and no other", async () => {
    const { relay, robot } = await reportedRobot();
    const { key } = await makeKey(relay, robot, "drive");
    const other = await RosClient.connect(relay, robot, { key });
    const client = await RosClient.connect(relay, robot);
    for (const text of [
      "{",
      "[]",
      '"',
      "{}",
      '{"op":1}',
      "7",
      '{"op":"subscribe"}',
      "null",
      "\n",
    ]) {
      client.sendText(text);
    }
    expect(await client.call("rosapi/nodes")).toMatchObject({ result: true });
    client.sendText(Buffer.from([1, 2]), true);
    expect((await client.closed).code).toBe(4400);
    expect(await other.call("rosapi/nodes")).toMatchObject({ result: true });
  });

  it("refuse messages of more than 16 KiB, and wrong UTF-8", async () => {
    const { relay, robot } = await reportedRobot();
    const large = await RosClient.connect(relay, robot);
    large.sendText("x".repeat(16 * 1024 + 1));
    expect((await large.closed).code).toBe(1009);
    const wrong = await RosClient.connect(relay, robot);
    wrong.sendText(Buffer.from([0xff, 0xfe]));
    expect((await wrong.closed).code).toBe(1007);
  });

  it.each([
    ["[".repeat(8_000) + "]".repeat(8_000)],
    ['{"op":"publish","topic":"/cmd_vel","msg":{"__proto__":{"linear":1}}}'],
    ['{"op":"publish","topic":"/cmd_vel","msg":{"linear":{"x":1e999}}}'],
    ['{"op":"publish","topic":"/cmd_vel","msg":{"linear":{"x":NaN}}}'],
    ['{"op":"constructor"}'],
    ['{"op":"call_service","service":"__proto__"}'],
    ['{"op":"subscribe","topic":"toString"}'],
  ])("let the client continue after %s", async (text) => {
    const { relay, robot } = await reportedRobot();
    const client = await RosClient.connect(relay, robot);
    client.sendText(text);
    expect(await client.call("rosapi/nodes")).toMatchObject({ result: true });
    expect((await rosScript(relay, robot))?.lastProblem).not.toBeNull();
  });

  it("permit 4 connections of a key", async () => {
    const { relay, robot } = await reportedRobot();
    for (let i = 0; i < 4; i += 1) {
      const client = await RosClient.connect(relay, robot);
      await client.call("rosapi/nodes");
    }
    const fifth = await RosClient.connect(relay, robot);
    expect((await fifth.closed).code).toBe(4429);
  });
});

describe("a relay", () => {
  it("logs no key of a ROS client, and no path", async () => {
    const lines: string[] = [];
    const log = pino({ level: "trace" }, { write: (line: string) => void lines.push(line) });
    const relay = await startTestRelay({ log });
    const robot = await relay.register();
    const { key } = await makeKey(relay, robot, "drive", "url");
    const wrong = `url_${"A".repeat(22)}`;
    expect(await RosClient.refusedWith(relay, robot, { pathKey: wrong })).toBe(401);
    const byPath = await RosClient.connect(relay, robot, { pathKey: key });
    byPath.sendText(`{"op":"auth","mac":"${key}"`);
    await byPath.call("/rosapi/nodes");
    const byAuth = await RosClient.connect(relay, robot, { key: null });
    byAuth.send({ op: "auth", mac: wrong });
    await byAuth.closed;
    const byHeader = await RosClient.connect(relay, robot);
    await byHeader.call("/rosapi/nodes");
    const text = lines.join("");
    expect(text).toContain("ROS client authenticated");
    for (const secret of [key, wrong, robot.driverKey]) {
      expect(text).not.toContain(secret.slice(4));
    }
    expect(text).not.toContain("/ros");
  });

  it("without the gateway answers 404", async () => {
    const relay = await startTestRelay({ config: { gateways: [] } });
    const robot = await relay.register();
    expect(await RosClient.refusedWith(relay, robot)).toBe(404);
    expect((await fetch(`${relay.origin}/r/${robot.id}/ros`)).status).toBe(404);
  });

  it("that stops closes connections as a restart", async () => {
    const { relay, robot } = await reportedRobot();
    const client = await RosClient.connect(relay, robot);
    await client.call("rosapi/nodes");
    await relay.close();
    expect((await client.closed).code).toBe(1012);
  });

  it("serves the client of a robot whose page is at the same time replaced", async () => {
    const { relay, robot } = await reportedRobot();
    const client = await RosClient.connect(relay, robot);
    client.send(subscribe);
    await client.next("topic", "/pose2d");
    const { socket: page, epoch } = await TestSocket.page(relay, robot);
    const pose = { x: 250, y: 150, heading: 90 };
    page.send({ type: "snapshot", epoch, snapshot: snapshotOf({ seq: 200, pose }) });
    await vi.waitFor(async () => {
      const { msg } = await client.next("topic", "/pose2d");
      expect(msg).toMatchObject({ x: 2.5 });
    });
  });
});
