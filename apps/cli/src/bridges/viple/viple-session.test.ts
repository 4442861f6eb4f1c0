import { RefusedError, type CommandRecord } from "@corridor/protocol";
import { ManualTimers, settled, snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { ManualPort } from "../../../../../packages/ros/src/testing/manual-port.ts";
import { readSensorSettings } from "./sensor-settings.ts";
import { VipleSession } from "./viple-session.ts";

/** Time in which only the newest motion of a new connection counts. */
const START_MS = 300;

interface Servo {
  servoId?: number;
  servoSpeed: number;
  isTurn?: boolean;
}

/** VIPLE, connected to a robot. @param ms time since then */
async function connected(capability: "drive" | "watch" = "drive", ms = START_MS) {
  const port = new ManualPort(capability);
  const timers = new ManualTimers();
  const sent: string[] = [];
  const problems: string[] = [];
  const session = new VipleSession({
    port,
    timers,
    settings: readSensorSettings({ unit: "cm" }),
    send: (text) => void sent.push(text),
    onProblem: (sentence) => void problems.push(sentence),
  });
  await timers.pass(ms);
  return {
    port,
    timers,
    sent,
    problems,
    session,
    servos: async (...servos: Servo[]): Promise<void> => {
      session.receive(JSON.stringify({ servos }));
      await settled();
    },
    /** The robot starts the newest command. */
    start: (): void => {
      port.report(snapshotOf({ command: port.orders.length }));
    },
    end: (seq: number, state: CommandRecord["state"], reason: string | null = null): void => {
      port.end(seq, { state, reason });
    },
  };
}

const wheels = (left: number, right: number): Servo[] => [
  { servoId: 3, servoSpeed: left },
  { servoId: 5, servoSpeed: right },
];
const turn = (degrees: number): Servo => ({ servoSpeed: degrees, isTurn: true });
const driven = (left: number, right: number, replace = false): object => ({
  action: "drive",
  left,
  right,
  lease: 500,
  ttl: 500,
  replace,
});

describe("a motion of VIPLE", () => {
  it("drives by a lease that is renewed until the next motion", async () => {
    const { servos, port, timers, start } = await connected();
    await servos(...wheels(0.5, 0.25));
    await timers.pass(0);
    start();
    await timers.pass(2_000);
    expect(new Set(port.orders.map((order) => JSON.stringify(order)))).toEqual(
      new Set([
        JSON.stringify({
          action: "drive",
          left: 0.5,
          right: 0.25,
          lease: 500,
          ttl: 500,
          replace: false,
        }),
      ]),
    );
    // Each before the lease of the one before ends.
    expect(port.orders.length).toBeGreaterThanOrEqual(7);
    expect(port.orders.length).toBeLessThanOrEqual(11);
  });

  it("stops once", async () => {
    const { servos, port, timers } = await connected();
    await servos(...wheels(1, 1));
    await timers.pass(200);
    port.orders.length = 0;
    await servos(...wheels(0, 0));
    await timers.pass(5_000);
    expect(port.orders).toEqual([driven(0, 0)]);
  });

  it("changes one wheel, and the other continues", async () => {
    const { servos, port, timers } = await connected();
    await servos(...wheels(0.5, 0.5));
    await timers.pass(150);
    await servos({ servoId: 3, servoSpeed: -0.5 });
    await timers.pass(150);
    expect(port.orders.at(-1)).toMatchObject({ left: -0.5, right: 0.5 });
  });

  it("turns once, and takes over from a velocity", async () => {
    const { servos, port, timers } = await connected();
    await servos(...wheels(1, 1));
    await timers.pass(0);
    await servos(turn(90));
    await timers.pass(5_000);
    expect(port.orders).toEqual([
      driven(1, 1),
      { action: "turn", degrees: 90, ttl: 2_000, replace: true },
    ]);
  });

  it("takes over from a turn", async () => {
    const { servos, port, timers, start } = await connected();
    await servos(turn(90));
    await timers.pass(100);
    await servos(...wheels(1, 1));
    await timers.pass(0);
    expect(port.orders.at(-1)).toEqual(driven(1, 1, true));
    start();
    await timers.pass(300);
    expect(port.orders.at(-1)).toEqual(driven(1, 1));
  });

  it("turns twice by the same angle", async () => {
    const { servos, port, timers } = await connected();
    for (let turns = 0; turns < 2; turns += 1) {
      await servos(turn(90));
      await timers.pass(100);
    }
    expect(port.orders).toHaveLength(2);
  });

  it("is one of at most 10 a second, and the newest, however many arrive", async () => {
    const { servos, port, timers } = await connected();
    for (let i = 1; i <= 1_000; i += 1) {
      await servos(i % 2 === 0 ? turn(i) : { servoSpeed: i / 1_000 });
      await timers.pass(1);
    }
    await timers.pass(100);
    expect(port.orders.length).toBeLessThanOrEqual(11);
    expect(port.orders.at(-1)).toMatchObject({ action: "turn", degrees: 1_000 });
  });

  it("waits for the first 300 ms, of which the newest counts", async () => {
    const { servos, port, timers } = await connected("drive", 0);
    for (let i = 1; i <= 100; i += 1) await servos({ servoSpeed: i / 100 });
    await timers.pass(START_MS - 1);
    expect(port.orders).toEqual([]);
    await timers.pass(1);
    expect(port.orders).toEqual([driven(1, 1)]);
  });

  it.each<[string, CommandRecord["state"]]>([
    ["the owner or a lost network ends it", "cancelled"],
    ["another script takes over", "superseded"],
  ])("does not begin again by itself if %s", async (_who, state) => {
    const { servos, port, timers, end } = await connected();
    await servos(...wheels(1, 1));
    await timers.pass(0);
    end(1, state);
    await timers.pass(5_000);
    expect(port.orders).toHaveLength(1);
    await servos(...wheels(1, 1));
    await timers.pass(300);
    expect(port.orders.length).toBeGreaterThan(1);
  });

  it.each<CommandRecord["state"]>(["superseded", "completed", "expired"])(
    "continues although an order before its newest one is %s",
    async (state) => {
      const { servos, port, timers, end } = await connected();
      await servos(...wheels(1, 1));
      await timers.pass(250);
      end(1, state);
      const before = port.orders.length;
      expect(before).toBeGreaterThan(1);
      await timers.pass(1_000);
      expect(port.orders.length).toBeGreaterThan(before);
    },
  );

  it("continues although the velocity before it has run out", async () => {
    const { servos, port, timers, end } = await connected();
    await servos(...wheels(0, 0));
    await timers.pass(450);
    await servos(...wheels(1, 1));
    await timers.pass(60);
    end(1, "cancelled");
    const before = port.orders.length;
    await timers.pass(1_000);
    expect(port.orders.length).toBeGreaterThan(before);
  });

  it("does not begin again after missed states", async () => {
    const { servos, port, timers } = await connected();
    await servos(...wheels(1, 1));
    await timers.pass(0);
    port.miss([]);
    await timers.pass(5_000);
    expect(port.orders).toHaveLength(1);
  });

  it("ends with the connection", async () => {
    const { servos, port, timers, session } = await connected();
    await servos(...wheels(1, 1));
    await timers.pass(0);
    session.close();
    await timers.pass(5_000);
    expect(port.orders).toHaveLength(1);
    expect(port.isClosed).toBe(true);
  });

  it("is refused with a sentence for a watch key, and not sent again", async () => {
    const { servos, timers, problems } = await connected("watch");
    await servos(...wheels(1, 1));
    await timers.pass(5_000);
    expect(problems).toEqual([expect.stringContaining("A watch key")]);
  });

  it("is not sent again after a refusal, until VIPLE sends it", async () => {
    const { servos, port, timers, problems } = await connected();
    const send = port.send.bind(port);
    port.send = async () => {
      throw new RefusedError({
        type: "/problems/driving-paused",
        title: "Paused",
        status: 409,
        detail: "Remote driving is paused.",
        errors: [],
      });
    };
    await servos(...wheels(1, 1));
    await timers.pass(1_000);
    expect(problems).toEqual(["Remote driving is paused."]);
    port.send = send;
    await timers.pass(1_000);
    expect(port.orders).toEqual([]);
    await servos(...wheels(1, 1));
    await timers.pass(60);
    expect(port.orders).toEqual([driven(1, 1)]);
  });
});

describe("a motion of VIPLE that the robot does not begin", () => {
  const NOT_DRIVING = "Remote is not driving: choose Remote on the robot's page.";

  it("is reported with the reason, and again if VIPLE sends it again", async () => {
    const { servos, timers, problems, end } = await connected();
    await servos(...wheels(1, 1));
    await timers.pass(0);
    end(1, "cancelled", NOT_DRIVING);
    await timers.pass(5_000);
    expect(problems).toEqual([NOT_DRIVING]);
    await servos(turn(90));
    await timers.pass(0);
    end(2, "cancelled", NOT_DRIVING);
    expect(problems).toEqual([NOT_DRIVING, NOT_DRIVING]);
  });

  it("is reported once, although the bridge repeats it", async () => {
    const { servos, port, timers, problems, end } = await connected();
    await servos(...wheels(1, 1));
    await timers.pass(1_000);
    expect(port.orders.length).toBeGreaterThan(2);
    for (const seq of port.orders.keys()) end(seq + 1, "expired", "The page is closed.");
    expect(problems).toEqual(["The page is closed."]);
  });

  it("is not reported if it has begun before it ends", async () => {
    const { servos, timers, problems, end } = await connected();
    await servos(...wheels(1, 1));
    await timers.pass(0);
    end(1, "started");
    end(1, "cancelled", "The owner stopped the robot.");
    expect(problems).toEqual([]);
  });
});

describe("a connection of VIPLE", () => {
  it("receives the readings", async () => {
    const { port, timers, sent } = await connected();
    await timers.pass(1_000);
    expect(sent).toEqual([]);
    port.report(snapshotOf({ sensors: { front: 60, right: 40, back: 1, left: 1 } }));
    await timers.pass(0);
    expect(sent).toEqual([
      '{"sensors":[{"name":"touch","id":0,"value":0},{"name":"distance","id":1,"value":40},{"name":"distance","id":2,"value":60}]}',
    ]);
    port.report(snapshotOf({ tick: 99, sensors: { front: 60, right: 40, back: 2, left: 2 } }));
    await timers.pass(240);
    expect(sent).toHaveLength(1);
    await timers.pass(10);
    expect(sent).toHaveLength(2);
  });

  it("reports a message that it ignores, and drives by the next", async () => {
    const { servos, port, timers, session, problems } = await connected();
    session.receive('{"servos":[{"servoSpeed":"fast"}]}');
    expect(problems).toEqual([
      'A message of VIPLE has servos[0].servoSpeed "fast", expected a number.',
    ]);
    await servos(...wheels(1, 1));
    await timers.pass(0);
    expect(port.orders).toHaveLength(1);
  });
});
