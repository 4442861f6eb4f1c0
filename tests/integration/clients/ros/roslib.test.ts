/** The JavaScript library of ROS, unchanged, drives a robot through a real relay. */
import { Action, Ros, Service, Topic } from "roslib";
import { describe, expect, it, onTestFinished } from "vitest";
import { corridorHost } from "../../../support/mcp/corridor-host.ts";
import { urlWithKey } from "../../../support/ros/url-with-key.ts";
import { sharedRelayProcess } from "../../../support/test-relay-process.ts";

interface Scan {
  ranges: number[];
}

interface MoveResult {
  state: string;
  distance: number;
  x: number;
  y: number;
}

const sharedRelay = sharedRelayProcess();

async function host() {
  const { relay, registration, page } = await corridorHost(await sharedRelay());
  const url = `${relay.url.replace("http", "ws")}/r/${registration.id}/ros`;
  return { relay, registration, page, url };
}

/** Connects as the library's documentation shows. @param key in `authenticate`; null: in the URL */
async function connect(url: string, key: string | null): Promise<Ros> {
  const ros = new Ros({ url });
  onTestFinished(() => ros.close());
  if (key !== null) ros.authenticate(key, "", "", "", 0, "", 0);
  await new Promise((resolve, reject) => {
    ros.on("connection", resolve);
    ros.on("error", reject);
  });
  return ros;
}

/** A robot, and a client with its driver key. */
async function connected() {
  const world = await host();
  return { ...world, ros: await connect(world.url, world.registration.driverKey) };
}

async function first<T>(topic: Topic<T>): Promise<T> {
  return new Promise((resolve) => {
    topic.subscribe((message) => resolve(message));
  });
}

async function call<T>(ros: Ros, name: string, serviceType: string, args = {}): Promise<T> {
  const service = new Service<object, T>({ ros, name, serviceType });
  return new Promise((resolve, reject) => {
    service.callService(args, resolve, (error: string) => reject(new Error(error)));
  });
}

const twist = (x: number) => ({ linear: { x, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0 } });

describe("roslib", () => {
  it.each(["message", "path"])(
    "connects with a key in the %s, and reads the robot",
    async (where) => {
      const { relay, registration, url } = await host();
      const ros = await (where === "message"
        ? connect(url, registration.driverKey)
        : connect(await urlWithKey(relay.url, registration), null));
      // The library calls back for the name as it stands here.
      for (const name of ["/scan", "scan"]) {
        const topic = new Topic<Scan>({ ros, name, messageType: "sensor_msgs/msg/LaserScan" });
        expect((await first(topic)).ranges).toHaveLength(4);
      }
      const odom = new Topic({ ros, name: "/odom", messageType: "nav_msgs/Odometry" });
      expect(await first(odom)).toMatchObject({ pose: { pose: { position: { x: 1.5, y: 5.5 } } } });
    },
  );

  it("drives by /cmd_vel and stops", async () => {
    const { page, ros } = await connected();
    const topic = new Topic({ ros, name: "/cmd_vel", messageType: "geometry_msgs/Twist" });
    topic.publish(twist(0.261));
    const power = { action: "drive", left: 0.1, right: 0.1 };
    await expect.poll(() => page.robot.done.at(-1)).toMatchObject(power);
    topic.publish(twist(0));
    const none = { action: "drive", left: 0, right: 0 };
    await expect.poll(() => page.robot.done.at(-1)).toMatchObject(none);
  });

  it("drives by the key of `authenticate`, although its URL only reads", async () => {
    const { relay, registration, page } = await host();
    const ros = await connect(
      await urlWithKey(relay.url, registration, "watch"),
      registration.driverKey,
    );
    const topic = new Topic({ ros, name: "/cmd_vel", messageType: "geometry_msgs/Twist" });
    topic.publish(twist(0.261));
    await expect.poll(() => page.robot.done.at(-1)).toMatchObject({ action: "drive", left: 0.1 });
  });

  it("moves with a result, receives the refusal of a wrong goal, and resets", async () => {
    const { page, ros } = await connected();
    const move = new Action<object, object, MoveResult>({
      ros,
      name: "/move",
      actionType: "corridor_msgs/action/Move",
    });
    const run = async (goal: object): Promise<MoveResult> =>
      new Promise((resolve, reject) => {
        move.sendGoal(goal, resolve, undefined, (error) => reject(new Error(error)));
      });
    expect(await run({ distance: 1 })).toMatchObject({ state: "completed", distance: 1, x: 2.5 });
    await expect(run({ metres: 1 })).rejects.toThrow("metres");
    const reset = await call(ros, "/reset", "std_srvs/Trigger");
    expect(reset).toMatchObject({ success: true });
    expect(page.robot.pose).toMatchObject({ x: 150, y: 150 });
  });

  it("receives feedback, and cancels a goal", async () => {
    const { page, ros } = await connected();
    page.endsCommands = false;
    const move = new Action<object, object, MoveResult>({
      ros,
      name: "/move",
      actionType: "corridor_msgs/action/Move",
    });
    const fed = Promise.withResolvers<object>();
    const ended = Promise.withResolvers<MoveResult>();
    const id = move.sendGoal({ distance: 1 }, ended.resolve, fed.resolve, (error) =>
      ended.reject(new Error(error)),
    );
    await expect.poll(() => page.started).toBe(1);
    page.connection.sendSnapshot(page.robot.snapshot({ command: 1 }));
    expect(await fed.promise).toMatchObject({ x: 1.5, y: 5.5 });
    move.cancelGoal(String(id));
    // The library reports every status but 4 as a failure, with the result as JSON.
    await expect(ended.promise).rejects.toThrow('"state":"cancelled"');
  });

  it("lists topics, services, types and the time", async () => {
    const { ros } = await connected();
    const topics = await new Promise<{ topics: string[]; types: string[] }>((resolve, reject) => {
      ros.getTopics(resolve, reject);
    });
    expect(topics.types[topics.topics.indexOf("/odom")]).toBe("nav_msgs/msg/Odometry");
    const services = await new Promise<string[]>((resolve, reject) => {
      ros.getServices(resolve, reject);
    });
    expect(services).toContain("/reset");
    const details = await new Promise<unknown[]>((resolve, reject) => {
      ros.getMessageDetails("geometry_msgs/Twist", resolve, reject);
    });
    expect(ros.decodeTypeDefs(details as never)).toMatchObject({ linear: { x: "float64" } });
    const { time } = await call<{ time: object }>(ros, "/rosapi/get_time", "rosapi/GetTime");
    expect(time).toMatchObject({ sec: expect.any(Number), secs: expect.any(Number) });
  });

  it("may only read with a watch key", async () => {
    const { relay, registration, page } = await host();
    const ros = await connect(await urlWithKey(relay.url, registration, "watch"), null);
    await expect(call(ros, "/reset", "std_srvs/Trigger")).rejects.toThrow("watch key");
    const topic = new Topic({ ros, name: "/cmd_vel", messageType: "geometry_msgs/Twist" });
    topic.publish(twist(1));
    const log = new Topic<{ msg: string }>({
      ros,
      name: "/rosout",
      messageType: "rcl_interfaces/Log",
    });
    expect((await first(log)).msg).toContain("watch key");
    expect(page.robot.done).toEqual([]);
  });
});
