import { RefusedError } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { RosClient } from "./testing/ros-client.ts";

describe("/cmd_vel", () => {
  const powers = (client: RosClient): unknown[] =>
    client.port.orders.map((order) => {
      if (order.action !== "drive") throw new Error(`found ${order.action}`);
      return [order.left, order.right];
    });

  it("drives by a lease", async () => {
    const client = await RosClient.connect();
    await client.drive(0.261, 0);
    expect(client.port.orders).toEqual([
      { action: "drive", left: 0.1, right: 0.1, lease: 500, ttl: 500, replace: false },
    ]);
  });

  it("drops a value that waited for an earlier order, which a lost network delayed", async () => {
    const client = await RosClient.connect();
    let arrive = (): void => undefined;
    const send = client.port.send.bind(client.port);
    client.port.send = async (order) => {
      await new Promise<void>((resolve) => (arrive = resolve));
      return send(order);
    };
    await client.drive(0.1);
    await client.timers.pass(100);
    await client.drive(0.2);
    await client.timers.pass(8_000);
    arrive();
    await client.timers.pass(1_000);
    expect(client.port.orders).toHaveLength(1);
    client.port.send = send;
    await client.drive(0.3);
    await client.timers.pass(100);
    expect(powers(client).at(-1)).toEqual([0.3 / 2.61, 0.3 / 2.61]);
  });

  it("says once why it moves nothing, until it moves again", async () => {
    const client = await RosClient.connect();
    await client.send({ op: "subscribe", topic: "/rosout" });
    const publish = async (): Promise<void> => {
      await client.drive(0.1);
      await client.timers.pass(200);
    };
    const reason = "Remote is not driving: choose Remote on the robot's page.";
    await publish();
    client.port.end(1, { state: "cancelled", reason });
    await publish();
    client.port.end(2, { state: "cancelled", reason });
    expect(client.problems).toEqual([reason]);
    expect(client.received("/rosout")).toMatchObject([{ level: 40, msg: reason }]);

    await publish();
    client.port.end(3, { state: "started" });
    client.port.end(3, { state: "cancelled", reason: "The lease ended." });
    expect(client.problems).toHaveLength(1);
    await publish();
    client.port.end(4, { state: "cancelled", reason });
    expect(client.problems).toEqual([reason, reason]);
  });

  it("takes over from a goal, and from commands of others", async () => {
    const client = await RosClient.connect();
    const replaces = (): unknown => client.port.orders.at(-1)?.replace;
    const goal = { action: "/move", args: { distance: 1 } };
    await client.send({ op: "send_action_goal", id: "g", ...goal });
    await client.drive(0.1);
    expect(replaces()).toBe(true);
    client.port.end(1, { state: "superseded" });
    await client.timers.pass(200);
    client.port.report(snapshotOf({ command: 2 }));
    await client.drive(0.2);
    expect(replaces()).toBe(false);
    client.port.report(snapshotOf({ command: 99 }));
    await client.timers.pass(200);
    await client.drive(0.3);
    expect(replaces()).toBe(true);
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

  it("sends the value that waits when its client disconnects, unless the connection is lost", async () => {
    const sentBy = async (code: number): Promise<unknown> => {
      const client = await RosClient.connect();
      await client.drive(0.1);
      await client.drive(0.2);
      client.session.disconnected(code);
      await client.timers.pass(1_000);
      return powers(client);
    };
    const first = [0.1 / 2.61, 0.1 / 2.61];
    expect(await sentBy(1000)).toEqual([first, [0.2 / 2.61, 0.2 / 2.61]]);
    expect(await sentBy(1006)).toEqual([first]);
  });

  describe("of a stream that falls silent", () => {
    const publish = async (client: RosClient, x: number): Promise<void> =>
      client.send({ op: "publish", topic: "/cmd_vel", msg: { linear: { x } } });
    /** A client that publishes ten times a second. @returns what was sent after a silence of 8 s */
    const silent = async (): Promise<RosClient> => {
      const client = await RosClient.connect();
      for (let i = 0; i < 10; i += 1) {
        await publish(client, i / 100);
        await client.timers.pass(100);
      }
      await client.timers.pass(8_000);
      client.port.orders.length = 0;
      return client;
    };

    it.each([
      ["at once", 0],
      ["in several reads", 1],
      ["slowly", 3],
    ])("takes the newest of what arrives %s after a stalled connection", async (_how, ms) => {
      const client = await silent();
      for (let i = 1; i <= 80; i += 1) {
        await publish(client, i / 100);
        await client.timers.pass(ms);
      }
      await client.timers.pass(1_000);
      expect(powers(client)).toEqual([[0.8 / 2.61, 0.8 / 2.61]]);
    });

    it("continues with the values that follow", async () => {
      const client = await silent();
      for (let i = 1; i <= 80; i += 1) await publish(client, i / 100);
      for (let i = 81; i <= 90; i += 1) {
        await client.timers.pass(100);
        await publish(client, i / 100);
      }
      await client.timers.pass(100);
      expect(powers(client)).toEqual(
        [82, 83, 84, 85, 86, 87, 88, 89, 90].map((i) => [i / 100 / 2.61, i / 100 / 2.61]),
      );
    });

    it("drives after a moment if it resumes with one value", async () => {
      const client = await silent();
      await publish(client, 0.5);
      await client.timers.pass(49);
      expect(client.port.orders).toEqual([]);
      await client.timers.pass(1);
      expect(powers(client)).toEqual([[0.5 / 2.61, 0.5 / 2.61]]);
    });
  });

  it("drives at once by single values", async () => {
    const client = await RosClient.connect();
    for (let i = 1; i <= 3; i += 1) {
      await client.drive(i / 10);
      expect(client.port.orders).toHaveLength(i);
      await client.timers.pass(1_000);
    }
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

  describe("with stamps of a clock", () => {
    const start = 1_800_000_000_000;
    const stamped = (ms: number, x: number): object => {
      const stamp = { sec: Math.floor(ms / 1_000), nanosec: Math.round((ms % 1_000) * 1e6) };
      const msg = { header: { stamp }, twist: { linear: { x } } };
      return { op: "publish", topic: "/cmd_vel", msg };
    };

    it.each([
      ["is set back", 100, -60_000],
      ["had been ahead once", 101, 0],
    ])("drives again within two seconds after the clock %s", async (_how, ahead, back) => {
      const client = await RosClient.connect();
      await client.send(stamped(start + (ahead - 100) * 5_000, 0.1));
      await client.timers.pass(200);
      client.port.orders.length = 0;
      for (let ms = 200; ms <= 2_200; ms += 200) {
        await client.send(stamped(start + back + ms, ms / 10_000));
        await client.timers.pass(200);
      }
      expect(powers(client).at(-1)).toEqual([0.22 / 2.61, 0.22 / 2.61]);
    });

    it("drives for a day although the clock drifts", async () => {
      const client = await RosClient.connect();
      for (let hour = 0; hour < 24; hour += 1) {
        const ms = hour * 3_600_000;
        await client.send(stamped(start + ms * 0.9999, (hour + 1) / 100));
        await client.timers.pass(3_600_000);
      }
      expect(client.port.orders).toHaveLength(24);
    });

    it("drops all that was stored, however slowly it arrives", async () => {
      const client = await RosClient.connect();
      await client.send(stamped(start, 0.1));
      await client.timers.pass(100_000);
      client.port.orders.length = 0;
      // 90 s of messages, ten times as fast as they were sent.
      for (let i = 0; i < 900; i += 1) {
        await client.send(stamped(start + i * 100, 0.9));
        await client.timers.pass(10);
      }
      expect(client.port.orders).toEqual([]);
    });
  });

  it("stops a goal, although the last velocity was zero too", async () => {
    const client = await RosClient.connect();
    await client.drive(0);
    await client.send({ op: "send_action_goal", action: "/move", id: "g", args: { distance: 1 } });
    await client.drive(0);
    await client.timers.pass(100);
    expect(client.port.orders.map(({ action }) => action)).toEqual(["drive", "move", "drive"]);
  });

  it.each([
    [
      "a goal, which ends what it would have ended",
      { op: "send_action_goal", action: "/move", args: { distance: 1 } },
      { action: "move", replace: true },
    ],
    ["a stop", { op: "call_service", service: "/stop" }, { action: "stop" }],
  ])("takes no effect after %s", async (_name, later, expected) => {
    const client = await RosClient.connect();
    await client.drive(0.5);
    await client.send({ op: "publish", topic: "/cmd_vel", msg: { linear: { x: 0 } } });
    await client.send({ ...later, id: "later" });
    await client.timers.pass(1_000);
    expect(client.port.orders).toMatchObject([{ action: "drive" }, expected]);
  });

  it("takes effect although a goal that cannot be served was sent later", async () => {
    const client = await RosClient.connect();
    await client.send({ op: "publish", topic: "/cmd_vel", msg: { linear: { x: 0.5 } } });
    await client.send({ op: "send_action_goal", id: "g", action: "/fly", args: {} });
    await client.send({ op: "call_service", id: "m", service: "/static_map" });
    await client.timers.pass(100);
    expect(powers(client)).toEqual([[0.5 / 2.61, 0.5 / 2.61]]);
  });

  it("is sent again after a refusal, although it has not changed", async () => {
    const client = await RosClient.connect();
    const refused = new RefusedError({
      type: "/problems/driving-paused",
      title: "Paused",
      status: 409,
      detail: "Remote driving is paused.",
      errors: [],
    });
    const { port } = client;
    const send = port.send.bind(port);
    port.send = async () => {
      throw refused;
    };
    await client.drive(0);
    port.send = send;
    await client.timers.pass(100);
    await client.drive(0);
    expect(client.problems).toEqual(["Remote driving is paused."]);
    expect(powers(client)).toEqual([[0, 0]]);
  });

  describe("with stamps of simulated time", () => {
    const stamped = (tick: number, x: number): object => {
      const stamp = { sec: Math.floor(tick / 60), nanosec: Math.round(((tick % 60) * 1e9) / 60) };
      const msg = { header: { stamp }, twist: { linear: { x } } };
      return { op: "publish", topic: "/cmd_vel", msg };
    };

    it.each([
      ["a quarter of the real", 15],
      ["16 times the real", 960],
    ])("drives at %s speed", async (_speed, ticksPerSecond) => {
      const client = await RosClient.connect();
      for (let second = 1; second <= 10; second += 1) {
        const tick = 600 + second * ticksPerSecond;
        client.port.report(snapshotOf({ tick }));
        await client.timers.pass(900);
        await client.send(stamped(tick, second / 10));
        await client.timers.pass(100);
      }
      expect(powers(client).at(-1)).toEqual([1 / 2.61, 1 / 2.61]);
      expect(client.port.orders).toHaveLength(10);
    });

    it("drops what is more than half a second late", async () => {
      const client = await RosClient.connect();
      for (let tick = 600; tick <= 720; tick += 6) {
        client.port.report(snapshotOf({ tick }));
        await client.timers.pass(100);
      }
      await client.send(stamped(660, 0.9));
      await client.timers.pass(200);
      await client.send(stamped(718, 0.1));
      await client.timers.pass(200);
      expect(powers(client)).toEqual([[0.1 / 2.61, 0.1 / 2.61]]);
    });
  });

  it("is refused for a watch key", async () => {
    const client = await RosClient.connect("watch");
    await client.drive(0.5);
    expect(client.problems).toEqual([expect.stringContaining("A watch key")]);
  });
});
