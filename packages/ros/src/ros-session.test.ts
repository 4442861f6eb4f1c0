import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { maze, RosClient } from "./testing/ros-client.ts";

const subscribe = (topic: string, more: object = {}): object => ({
  op: "subscribe",
  topic,
  ...more,
});

describe("a subscriber", () => {
  it.each([
    ["/pose2d", { x: 1.5, y: 0.5, theta: 0 }],
    ["/bumper", { data: false }],
    ["/clock", { clock: { sec: 1, nanosec: 0, secs: 1, nsecs: 0 } }],
    ["/range/left", { range: 0.5, header: { frame_id: "range_left" }, max_range: 512 }],
    ["/scan", { ranges: [0.495, 0.5, 2.505, 0.5], angle_min: -Math.PI }],
    [
      "/odom",
      { pose: { pose: { position: { x: 1.5, y: 0.5, z: 0 } } }, child_frame_id: "base_link" },
    ],
    ["/tf", { transforms: [{ header: { frame_id: "odom" }, child_frame_id: "base_link" }] }],
    ["/map", { info: { width: 3, height: 2, resolution: 1 }, data: [0, 0, 100, 100, 0, 0] }],
    ["odom", { header: { frame_id: "odom", stamp: { sec: 1, secs: 1 } } }],
  ])("of %s receives the newest message at once", async (topic, message) => {
    const client = await RosClient.connect();
    await client.send(subscribe(topic));
    expect(client.frames).toMatchObject([{ op: "publish", msg: message }]);
    expect(client.frames[0]).not.toHaveProperty("id");
  });

  it("reads the native snapshot as text", async () => {
    const client = await RosClient.connect();
    await client.send(subscribe("/corridor/snapshot"));
    const [message] = client.received("/corridor/snapshot") as { data: string }[];
    expect(JSON.parse(message?.data ?? "")).toEqual(snapshotOf());
  });

  it("receives all static transforms", async () => {
    const client = await RosClient.connect();
    await client.send(subscribe("/tf_static"));
    const [message] = client.received("/tf_static") as { transforms: object[] }[];
    expect(message?.transforms).toHaveLength(6);
  });

  it("receives the velocity in its own frame", async () => {
    const client = await RosClient.connect();
    const pose = { x: 160, y: 150, heading: 90 };
    client.port.report(snapshotOf({ tick: 66, pose }));
    await client.send(subscribe("/odom"));
    expect(client.received("/odom")[0]).toMatchObject({
      twist: { twist: { linear: { x: 1 }, angular: { z: 0 } } },
    });
  });

  it("receives a message that waits by a lower throttle rate at once", async () => {
    const client = await RosClient.connect();
    await client.send(subscribe("/pose2d", { id: "a", throttle_rate: 10_000 }));
    client.port.report(snapshotOf({ tick: 10 }));
    await client.timers.pass(1_000);
    const before = client.received("/pose2d").length;
    await client.send(subscribe("/pose2d", { id: "b", throttle_rate: 100 }));
    await client.timers.pass(100);
    expect(client.received("/pose2d").length).toBeGreaterThan(before);
  });

  it("receives each message once, by the lowest throttle rate, and the newest", async () => {
    const client = await RosClient.connect();
    await client.send(subscribe("/pose2d", { id: "a", throttle_rate: 500 }));
    await client.send(subscribe("/pose2d", { id: "b", throttle_rate: 100 }));
    await client.timers.pass(100);
    client.frames.length = 0;
    for (const x of [151, 152, 153]) {
      client.port.report(snapshotOf({ pose: { x, y: 150, heading: 90 } }));
    }
    await client.timers.pass(99);
    expect(client.received("/pose2d")).toEqual([]);
    await client.timers.pass(1);
    expect(client.received("/pose2d")).toMatchObject([{ x: 1.53 }]);
  });

  it("receives at most 20 messages a second", async () => {
    const client = await RosClient.connect();
    await client.send(subscribe("/bumper"));
    for (let ms = 0; ms < 1000; ms += 10) {
      client.port.report(snapshotOf({ tick: 60 + ms }));
      await client.timers.pass(10);
    }
    expect(client.received("/bumper")).toHaveLength(21);
  });

  it("receives nothing after it has unsubscribed", async () => {
    const client = await RosClient.connect();
    await client.send(subscribe("/bumper", { id: "a" }));
    await client.send(subscribe("/bumper", { id: "b" }));
    await client.send({ op: "unsubscribe", topic: "/bumper", id: "a" });
    client.port.report(snapshotOf({ tick: 61 }));
    await client.timers.pass(60);
    expect(client.received("/bumper")).toHaveLength(2);
    await client.send({ op: "unsubscribe", topic: "bumper" });
    client.port.report(snapshotOf({ tick: 62 }));
    await client.timers.pass(60);
    expect(client.received("/bumper")).toHaveLength(2);
  });

  it("receives each topic under the name that it wrote, once", async () => {
    const client = await RosClient.connect();
    for (const topic of ["bumper", "/bumper", "bumper"]) await client.send(subscribe(topic));
    await client.send({ op: "unsubscribe", topic: "/bumper", id: "none" });
    await client.timers.pass(60);
    client.frames.length = 0;
    client.port.report(snapshotOf({ tick: 61 }));
    await client.timers.pass(60);
    expect(client.frames.map(({ topic }) => topic)).toEqual(["bumper", "/bumper"]);
  });

  it("receives the map again in another maze", async () => {
    const client = await RosClient.connect();
    await client.send(subscribe("/map"));
    client.port.enter({ ...maze, blocks: ["...", "...", "..."] });
    await client.timers.pass(60);
    expect(client.received("/map")).toMatchObject([
      { info: { height: 2 } },
      { info: { height: 3 } },
    ]);
  });

  it("learns on /rosout what was refused", async () => {
    const client = await RosClient.connect();
    await client.send(subscribe("/rosout"));
    expect(client.frames).toEqual([]);
    await client.send(subscribe("/nothing"));
    expect(client.received("/rosout")).toMatchObject([
      { level: 40, msg: "The robot does not publish /nothing." },
    ]);
    expect(client.problems).toEqual(["The robot does not publish /nothing."]);
  });

  it("waits until the maze can be read, because y depends on its height", async () => {
    const client = await RosClient.connect();
    client.port.newest = null;
    await client.send(subscribe("/pose2d"));
    client.port.mazeStatus = 503;
    client.port.enter({ ...maze, blocks: ["...", "...", "..."] });
    await client.timers.pass(500);
    client.frames.length = 0;
    client.port.report(snapshotOf({ pose: { x: 150, y: 50, heading: 90 } }));
    await client.timers.pass(100);
    expect(client.received("/pose2d")).toEqual([]);
    client.port.mazeStatus = 200;
    await client.timers.pass(1_000);
    expect(client.received("/pose2d")).toMatchObject([{ y: 2.5 }]);
  });

  it("of a robot without a maze measures y from its top edge", async () => {
    const client = await RosClient.connect("drive", false);
    await client.send(subscribe("/pose2d"));
    expect(client.received("/pose2d")).toMatchObject([{ x: 1.5, y: -1.5 }]);
  });

  it("may have 256 subscriptions", async () => {
    const client = await RosClient.connect();
    for (let id = 0; id < 257; id += 1) await client.send(subscribe("/odom", { id }));
    expect(client.problems).toEqual([expect.stringContaining("256 subscriptions")]);
  });
});

describe("a request that is refused without a reply", () => {
  it.each([
    [{ op: "advertise", topic: "/cmd_vel", type: "std_msgs/String" }, "not std_msgs/String"],
    [{ op: "advertise", topic: "/odom", type: "nav_msgs/Odometry" }, "only to /cmd_vel"],
    [{ op: "publish", topic: "/other", msg: {} }, "only to /cmd_vel"],
    [
      { op: "publish", topic: "/cmd_vel", msg: { linear: { a: 1 } } },
      "linear.a: geometry_msgs/Vector3",
    ],
    [
      { op: "publish", topic: "/cmd_vel", msg: { linear: { x: "fast" } } },
      "linear.x: found 'fast'",
    ],
    [{ op: "publish", topic: "/cmd_vel" }, "no valid field 'msg'"],
    [{ op: "subscribe", topic: "/odom", type: "std_msgs/String" }, "not std_msgs/String"],
    [{ op: "subscribe", topic: "/odom", compression: "cbor-raw" }, "cbor-raw"],
    [{ op: "advertise_service", service: "/a", type: "b" }, "'advertise_service'"],
    [{ op: "advertise_action", action: "/a", type: "b" }, "'advertise_action'"],
    [{ op: "fragment", id: "1", data: "", num: 0, total: 1 }, "'fragment'"],
    [{ op: "cancel_action_goal", action: "/move", id: "none" }, "no goal with this id"],
    [{ op: "subscribe" }, "no valid field 'topic'"],
  ])("%j is explained", async (message, expected) => {
    const client = await RosClient.connect();
    await client.send(message);
    expect(client.problems).toEqual([expect.stringContaining(expected)]);
    expect(client.frames).toEqual([]);
    expect(client.failures).toEqual([]);
  });

  it.each(["", "{", "[]", "7", "null", '{"op":7}', '{"a":1}', `{"op":"${"x".repeat(20_000)}"}`])(
    "%j cannot be read",
    async (text) => {
      const client = await RosClient.connect();
      expect(client.session.receive(text)).toBe(false);
    },
  );

  it("closes the connection when ten messages could not be read", async () => {
    const client = await RosClient.connect();
    for (let i = 1; i < 10; i += 1) client.session.receive("{");
    expect(client.closings).toEqual([]);
    for (let i = 0; i < 3; i += 1) client.session.receive("{");
    expect(client.closings).toEqual([4400]);
  });

  it("is sent as status to clients that asked for it", async () => {
    const client = await RosClient.connect();
    await client.send({ op: "set_level", level: "error" });
    await client.send(subscribe("/nothing"));
    expect(client.frames).toMatchObject([{ op: "status", level: "error" }]);
  });
});
