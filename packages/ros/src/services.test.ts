import { describe, expect, it } from "vitest";
import { RosClient } from "./testing/ros-client.ts";

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

  it.each(["/stop", "/reset"])(
    "%s answers before its client has waited 3 s, although its command has not ended",
    async (service) => {
      const client = await RosClient.connect();
      const { port } = client;
      const send = port.send.bind(port);
      port.send = async (order) => {
        await new Promise<void>((resolve) => void client.timers.after(400, resolve));
        return send(order);
      };
      port.endOf = async (seq: number, milliseconds = 0) => {
        await new Promise<void>((resolve) => void client.timers.after(milliseconds, resolve));
        return port.cancel(seq);
      };
      await client.send({ op: "call_service", id: 7, service });
      await client.timers.pass(2_999);
      const message = expect.stringMatching(/has not ended after 2\.5 s\.$/);
      expect(client.frames).toMatchObject([
        { id: 7, result: true, values: { success: false, message } },
      ]);
    },
  );

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
    ["get_param", { name: "a" }, { value: '""' }],
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
