import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { maze, RosClient, type Frame } from "./testing/ros-client.ts";

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

  it("is sent as status to clients that asked for it", async () => {
    const client = await RosClient.connect();
    await client.send({ op: "set_level", level: "error" });
    await client.send(subscribe("/nothing"));
    expect(client.frames).toMatchObject([{ op: "status", level: "error" }]);
  });
});

describe("/cmd_vel", () => {
  const powers = (client: RosClient): unknown[] =>
    client.port.orders.map((order) => {
      if (order.action !== "drive") throw new Error(`found ${order.action}`);
      return [order.left, order.right];
    });

  it("drives by a lease, and takes over", async () => {
    const client = await RosClient.connect();
    await client.drive(0.261, 0);
    expect(client.port.orders).toEqual([
      { action: "drive", left: 0.1, right: 0.1, lease: 500, ttl: 500, replace: true },
    ]);
  });

  it.each([
    [0, 1.305, [-0.1, 0.1]],
    [5.22, 0, [1, 1]],
    [2.61, 13.05, [0, 1]],
    [-2.61, 0, [-1, -1]],
    [1e308, 1e308, [0.6666666666666667, 1]],
  ])("linear %d and angular %d become wheel powers", async (linear, angular, expected) => {
    const client = await RosClient.connect();
    await client.drive(linear, angular);
    const [sent] = powers(client) as [number[]];
    for (const [index, power] of expected.entries()) expect(sent[index]).toBeCloseTo(power, 9);
  });

  it("takes the newest of what a client has stored while it was disconnected", async () => {
    const client = await RosClient.connect();
    client.session.close();
    const again = await RosClient.connect();
    for (let i = 1; i <= 100; i += 1) {
      await again.send({ op: "publish", topic: "/cmd_vel", msg: { linear: { x: i / 100 } } });
    }
    await again.timers.pass(1_000);
    expect(powers(again)).toEqual([[1 / 2.61, 1 / 2.61]]);
  });

  it("sends at most 10 orders a second, and the newest", async () => {
    const client = await RosClient.connect();
    for (let i = 0; i < 50; i += 1) {
      await client.drive(i / 100);
      await client.timers.pass(20);
    }
    await client.timers.pass(100);
    expect(client.port.orders.length).toBeLessThanOrEqual(11);
    expect(powers(client).at(-1)).toEqual([0.49 / 2.61, 0.49 / 2.61]);
  });

  it("renews an unchanged value, and sends zero once", async () => {
    const client = await RosClient.connect();
    for (let i = 0; i < 10; i += 1) {
      await client.drive(0.5);
      await client.timers.pass(100);
    }
    expect(client.port.orders).toHaveLength(5);
    for (let i = 0; i < 10; i += 1) {
      await client.drive(0);
      await client.timers.pass(100);
    }
    expect(powers(client).slice(5)).toEqual([[0, 0]]);
  });

  it("drops a stamped message that is late", async () => {
    const client = await RosClient.connect();
    const stamped = async (sec: number, x: number): Promise<void> => {
      const msg = { header: { stamp: { sec, nanosec: 0 } }, twist: { linear: { x } } };
      await client.send({ op: "publish", topic: "/cmd_vel", msg });
      await client.timers.pass(200);
    };
    await stamped(1_000, 0.1);
    await stamped(999, 0.9);
    await stamped(1_001, 0.2);
    expect(powers(client)).toEqual([
      [0.1 / 2.61, 0.1 / 2.61],
      [0.2 / 2.61, 0.2 / 2.61],
    ]);
  });

  it("is refused for a watch key", async () => {
    const client = await RosClient.connect("watch");
    await client.drive(0.5);
    expect(client.problems).toEqual([expect.stringContaining("A watch key")]);
  });
});

describe("a service", () => {
  it.each(["/stop", "/reset"])("%s answers when its command has ended", async (service) => {
    const client = await RosClient.connect();
    await client.send({ op: "call_service", id: 7, service });
    expect(client.frames).toEqual([]);
    client.port.end(1, { state: "completed" });
    await client.timers.pass(0);
    expect(client.port.orders).toEqual([{ action: service.slice(1) }]);
    const values = { success: true, message: "" };
    expect(client.frames).toEqual([
      { op: "service_response", id: 7, service, values, result: true },
    ]);
  });

  it("/static_map answers with the map", async () => {
    const client = await RosClient.connect();
    const answer = await client.call("static_map");
    expect(answer).toMatchObject({ result: true, values: { map: { info: { width: 3 } } } });
  });

  it.each([
    ["/nothing", {}, "The robot has no service /nothing."],
    ["/stop", { now: true }, "now: std_srvs/Trigger_Request has no field of this name."],
    ["/rosapi/set_param", { name: "a", value: "1" }, "The robot has no parameters."],
    ["/rosapi/topic_type", [1, 2], "has 1 fields, and the list has 2"],
    ["/rosapi/topic_type", { topic: 3 }, "topic: found 3, expected a text."],
  ])("%s with %j answers why it fails", async (service, args, expected) => {
    const client = await RosClient.connect();
    const answer = await client.call(service, args);
    expect(answer).toMatchObject({ op: "service_response", service, result: false });
    expect(answer["values"]).toContain(expected);
  });
});

describe("a goal", () => {
  const goal = (action: string, args: object, more: object = {}): object => ({
    op: "send_action_goal",
    id: "goal-1",
    action,
    args,
    feedback: true,
    ...more,
  });
  const results = ({ frames }: RosClient): Frame[] =>
    frames.filter(({ op }) => op === "action_result");

  it.each([
    ["/move", { distance: 1.5 }, { action: "move", distance: 150 }],
    ["/turn", { angle: Math.PI / 2 }, { action: "turn", degrees: -90 }],
    ["do", { action: "left 90" }, { action: "left 90" }],
  ])("%s with %j becomes a command", async (action, args, order) => {
    const client = await RosClient.connect();
    await client.send(goal(action, args));
    expect(client.port.orders).toEqual([order]);
  });

  it("sends feedback, and its result at the end", async () => {
    const client = await RosClient.connect();
    await client.send(goal("/move", { distance: 1 }, { action_type: "corridor_msgs/action/Move" }));
    client.port.report(snapshotOf({ command: 1 }));
    client.port.report(snapshotOf({ command: 1, pose: { x: 190, y: 150, heading: 90 } }));
    expect(client.frames.at(-1)).toEqual({
      op: "action_feedback",
      id: "goal-1",
      action: "/move",
      values: { distance: 0.4, x: 1.9, y: 0.5, theta: 0 },
    });
    const pose = { x: 250, y: 150, heading: 90 };
    client.port.end(1, { state: "completed", distance: 100, pose });
    await client.timers.pass(0);
    expect(results(client)).toEqual([
      {
        op: "action_result",
        id: "goal-1",
        action: "/move",
        values: { state: "completed", reason: "", distance: 1, x: 2.5, y: 0.5, theta: 0 },
        status: 4,
        result: true,
      },
    ]);
  });

  it.each([
    ["completed", 4],
    ["cancelled", 5],
    ["collided", 6],
    ["superseded", 6],
    ["expired", 6],
  ] as const)("that ends as %s has the status %i", async (state, status) => {
    const client = await RosClient.connect();
    await client.send(goal("/move", { distance: 1 }));
    client.port.end(1, { state });
    await client.timers.pass(0);
    expect(results(client)).toMatchObject([{ status, result: true, values: { state } }]);
  });

  it("is cancelled by its id", async () => {
    const client = await RosClient.connect();
    await client.send(goal("/move", { distance: 1 }));
    await client.send({ op: "cancel_action_goal", action: "move", id: "goal-1" });
    expect(client.port.cancelled).toEqual([1]);
  });

  it.each([
    [goal("/fly", {}), "The robot has no action /fly"],
    [goal("/do", { action: "fly" }), "action: expected one of forward"],
    [
      goal("/move", { distance: 1 }, { action_type: "corridor_msgs/Turn" }),
      "not corridor_msgs/Turn",
    ],
    [goal("/move", { distance: 1e9 }), "Invalid command."],
    [goal("/move", { far: 1 }), "far: corridor_msgs/Move_Goal has no field"],
  ])("that cannot be served has a sentence as its result: %j", async (message, expected) => {
    const client = await RosClient.connect();
    await client.send(message);
    const [result] = results(client);
    expect(result).toMatchObject({ id: "goal-1", status: 0, result: false });
    expect(result?.["values"]).toContain(expected);
  });

  it("of a watch key is refused", async () => {
    const client = await RosClient.connect("watch");
    await client.send(goal("/move", { distance: 1 }));
    const values = expect.stringContaining("A watch key permits only reading.");
    expect(results(client)).toEqual([expect.objectContaining({ result: false, values })]);
  });
});

describe("rosapi", () => {
  it.each([
    ["topics", {}, { topics: expect.arrayContaining(["/cmd_vel", "/odom"]) }],
    ["topics_for_type", { type: "nav_msgs/Odometry" }, { topics: ["/odom"] }],
    ["topic_type", { topic: "odom" }, { type: "nav_msgs/msg/Odometry" }],
    ["topic_type", { topic: "/none" }, { type: "" }],
    ["services", {}, { services: expect.arrayContaining(["/stop", "/rosapi/topics"]) }],
    ["services_for_type", { type: "std_srvs/srv/Trigger" }, { services: ["/stop", "/reset"] }],
    ["service_type", { service: "/stop" }, { type: "std_srvs/srv/Trigger" }],
    ["service_node", { service: "/stop" }, { node: "/corridor" }],
    ["service_providers", { service: "/none" }, { providers: [] }],
    ["nodes", {}, { nodes: ["/corridor"] }],
    ["node_details", { node: "/corridor" }, { subscribing: ["/cmd_vel"] }],
    ["publishers", { topic: "/odom" }, { publishers: ["/corridor"] }],
    ["subscribers", { topic: "/cmd_vel" }, { subscribers: ["/corridor"] }],
    ["action_servers", {}, { action_servers: ["/move", "/turn", "/do"] }],
    ["interfaces", {}, { interfaces: expect.arrayContaining(["corridor_msgs/action/Move"]) }],
    ["get_param", { name: "a", default_value: "1" }, { value: "1" }],
    ["has_param", { name: "a" }, { exists: false }],
    ["get_param_names", {}, { names: [] }],
    ["get_time", {}, { time: { sec: 1, nanosec: 0, secs: 1, nsecs: 0 } }],
    ["get_ros_version", {}, { version: 2, distro: "jazzy" }],
    [
      "service_response_details",
      { type: "std_srvs/Trigger" },
      { typedefs: [{ type: "std_srvs/srv/Trigger_Response", fieldnames: ["success", "message"] }] },
    ],
  ])("%s of %j answers", async (name, args, values) => {
    const client = await RosClient.connect();
    expect(await client.call(`rosapi/${name}`, args)).toMatchObject({ result: true, values });
  });

  it("describes a message with all that it contains", async () => {
    const client = await RosClient.connect();
    const { values } = await client.call("/rosapi/message_details", {
      type: "geometry_msgs/Twist",
    });
    expect(values).toMatchObject({
      typedefs: [
        {
          type: "geometry_msgs/msg/Twist",
          fieldnames: ["linear", "angular"],
          fieldtypes: ["geometry_msgs/msg/Vector3", "geometry_msgs/msg/Vector3"],
          fieldarraylen: [-1, -1],
        },
        { type: "geometry_msgs/msg/Vector3", fieldnames: ["x", "y", "z"] },
      ],
    });
  });

  it("prints the definitions of all topics", async () => {
    const client = await RosClient.connect();
    const { values } = await client.call("/rosapi/topics_and_raw_types");
    const { topics, typedefs_full_text: texts } = values as Record<string, string[]>;
    expect(texts).toHaveLength(topics?.length ?? 0);
    expect(texts?.[topics?.indexOf("/clock") ?? 0]).toBe(
      `builtin_interfaces/Time clock\n${"=".repeat(80)}\nMSG: builtin_interfaces/msg/Time\nint32 sec\nuint32 nanosec`,
    );
  });
});
