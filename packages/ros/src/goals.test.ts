import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { RosClient, type Frame } from "./testing/ros-client.ts";

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

  it("has its result, although it ended before its command was acknowledged", async () => {
    const client = await RosClient.connect();
    const { port } = client;
    const send = port.send.bind(port);
    port.send = async (order) => {
      const record = await send(order);
      const acknowledged = { ...record };
      port.end(record.seq, { state: "collided" });
      return acknowledged;
    };
    await client.send(goal("/move", { distance: 1 }));
    expect(results(client)).toMatchObject([{ status: 6, values: { state: "collided" } }]);
  });

  it("has its result, although a slow connection missed its end", async () => {
    const client = await RosClient.connect();
    await client.send(goal("/move", { distance: 1 }));
    await client.send(goal("/move", { distance: 2 }, { id: "goal-2" }));
    const { port } = client;
    port.end(1, { state: "started" });
    port.endOf = async (seq) => ({
      ...(await port.cancel(seq)),
      state: "completed",
      distance: 100,
    });
    port.miss([{ seq: 2, state: "started" }]);
    await client.timers.pass(0);
    expect(results(client)).toMatchObject([{ id: "goal-1", status: 4 }]);
  });

  it("waits as one reader of the robot, so that many goals exclude no other script", async () => {
    const client = await RosClient.connect();
    for (let n = 1; n <= 60; n += 1) {
      await client.send(goal("/move", { distance: 1 }, { id: `goal-${n}` }));
    }
    expect(client.port.waits).toBe(1);
    for (let n = 1; n <= 60; n += 1) client.port.end(n, { state: "completed" });
    await client.timers.pass(0);
    expect(results(client)).toHaveLength(60);
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
