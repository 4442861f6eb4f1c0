/** Frames as other ROS clients send them, and the answers that these clients require. */
import { describe, expect, it } from "vitest";
import { RosClient } from "./testing/ros-client.ts";

describe("a client", () => {
  it.each([
    [
      "ROS#",
      { op: "call_service", id: null, service: "/rosapi/nodes", args: {} },
      { op: "service_response", id: null, service: "/rosapi/nodes", result: true },
    ],
    [
      "roslib 1.4",
      {
        op: "call_service",
        id: "call_service:/rosapi/topic_type:2",
        service: "/rosapi/topic_type",
        type: "rosapi/TopicType",
        args: { topic: "/odom" },
      },
      { id: "call_service:/rosapi/topic_type:2", values: { type: "nav_msgs/msg/Odometry" } },
    ],
    [
      "roslib 2.1",
      { op: "call_service", id: "0b9f6c1e", service: "rosapi/get_ros_version", timeout: 3 },
      { id: "0b9f6c1e", service: "rosapi/get_ros_version", values: { version: 2 }, result: true },
    ],
    [
      "jrosbridge",
      { op: "call_service", id: "call_service:/rosapi/nodes:0", service: "/rosapi/nodes" },
      { id: "call_service:/rosapi/nodes:0", values: { nodes: ["/corridor"] }, result: true },
    ],
    [
      "ros-mcp-server",
      {
        op: "call_service",
        id: 7,
        service: "/rosapi/topics",
        type: "rosapi_msgs/srv/Topics",
        args: [],
        compression: "none",
        fragment_size: 1_000,
      },
      { id: 7, values: { topics: expect.arrayContaining(["/cmd_vel"]) }, result: true },
    ],
    [
      "ROS#, which subscribes",
      {
        op: "subscribe",
        id: "/odom:1",
        topic: "/odom",
        type: "nav_msgs/Odometry",
        throttle_rate: 0,
        queue_length: 1,
        fragment_size: 2_147_483_647,
        compression: "none",
      },
      { op: "publish", topic: "/odom" },
    ],
    [
      "roslib 2.1, which accepts compressed answers",
      { op: "subscribe", id: "5d0c", topic: "bumper", compression: "cbor", throttle_rate: 100 },
      { op: "publish", topic: "bumper", msg: { data: false } },
    ],
  ])("%s receives the answer that it requires", async (_name, request, answer) => {
    const client = await RosClient.connect();
    await client.send(request);
    expect(client.frames).toMatchObject([answer]);
    expect(client.problems).toEqual([]);
  });

  it.each([
    {
      op: "advertise",
      id: "a:1",
      topic: "/cmd_vel",
      type: "geometry_msgs/msg/Twist",
      latch: false,
    },
    { op: "advertise", topic: "cmd_vel", type: "geometry_msgs/TwistStamped", queue_size: 100 },
    { op: "unadvertise", id: "a:1", topic: "/cmd_vel" },
    { op: "set_level", level: "none" },
    { op: "auth", mac: "key", client: "", dest: "", rand: "", t: 0, level: "", end: 0 },
    { op: "unsubscribe", id: null, topic: "/odom" },
    {
      op: "publish",
      topic: "/cmd_vel",
      msg: { header: { stamp: { secs: 0, nsecs: 0 }, frame_id: "" }, twist: { linear: { x: 1 } } },
    },
    {
      op: "publish",
      topic: "/cmd_vel",
      msg: { header: { stamp: "now" }, twist: {} },
      latch: false,
    },
  ])("%j has no answer, and is no problem", async (message) => {
    const client = await RosClient.connect();
    await client.send(message);
    await client.timers.pass(100);
    expect(client.frames).toEqual([]);
    expect(client.problems).toEqual([]);
  });
});
