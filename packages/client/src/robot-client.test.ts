import { snapshotOf } from "@corridor/protocol/testing";
import { termsOf, type CommandRecord, type Order, type Snapshot } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { RobotClient } from "./robot-client.ts";
import { FakePlatform } from "./testing/fake-platform.ts";
import { ADDRESS, record } from "./testing/messages.ts";

const WELCOME = { type: "welcome", version: 1, stream: "k3J9x2aB", n: 0, snapshot: null };
const CLOSED = "Write await before each call, and call close() last. To continue, connect again.";
const tooLate = {
  type: "/problems/too-late",
  title: "Late",
  status: 422,
  detail: "d",
  errors: [],
};

async function connected() {
  const platform = new FakePlatform();
  /** number of the newest state */
  let n = 0;
  const opening = RobotClient.connect(ADDRESS, { platform });
  const welcome = (stream = "k3J9x2aB", snapshot: Snapshot | null = null): void => {
    platform.socket.open();
    platform.socket.receive({ type: "welcome", version: 1, stream, n, snapshot });
  };
  welcome();
  const robot = await opening;
  /** The commands on the newest socket. */
  const sent = () =>
    platform.socket.sent.filter(({ type }) => type === "command") as unknown as {
      key: string;
      sentAt: number;
      command: Order;
    }[];
  const report = (
    type: "ack" | "state",
    seq: number,
    change: Partial<CommandRecord> = {},
  ): void => {
    const { key, command } = keyed.get(seq) ??
      sent().at(-1) ?? { key: "", command: { action: "stop" } };
    keyed.set(seq, { key, command });
    if (type === "state") n += 1;
    platform.socket.receive({
      type,
      ...(type === "state" && { n }),
      record: record(seq, key, termsOf(command).command, change),
    });
  };
  const keyed = new Map<number, { key: string; command: Order }>();
  return { platform, robot, sent, report, welcome };
}

it("names connect() if a script calls the constructor, which JavaScript permits", () => {
  expect(() => void Reflect.construct(RobotClient, [ADDRESS])).toThrow(
    "new RobotClient() does not connect (bad-command). Use: await RobotClient.connect(address).",
  );
});

describe("reset", () => {
  it("resolves when the robot is at its start, and is sent again while the robot accepts none", async () => {
    const { platform, robot, sent, report } = await connected();
    const reset = robot.reset();
    expect(sent()[0]?.command).toEqual({ action: "reset" });
    const problem = { ...tooLate, type: "/problems/too-fast", status: 429 };
    platform.socket.receive({ type: "problem", key: sent()[0]?.key, problem });
    platform.pass(1_000);
    expect(sent().map(({ key }) => key)).toEqual([sent()[0]?.key, sent()[0]?.key]);
    report("ack", 1);
    report("state", 1, { state: "completed", distance: 0 });
    expect(await reset).toMatchObject({ action: "reset", state: "completed" });
  });

  it.each([
    { status: 403, type: "/problems/reset-disabled" },
    { status: 422, type: "/problems/not-supported" },
  ])("rejects with $type, and the script continues", async (refusal) => {
    const { platform, robot, sent, report } = await connected();
    const reset = robot.reset();
    const problem = { ...tooLate, ...refusal };
    platform.socket.receive({ type: "problem", key: sent()[0]?.key, problem });
    await expect(reset).rejects.toMatchObject({ code: "refused" });
    const next = robot.left90();
    report("ack", 1);
    report("state", 1, { state: "completed" });
    expect(await next).toMatchObject({ state: "completed" });
  });
});

describe("a record with an action that this version does not know", () => {
  it("is read, like any other", async () => {
    const { platform, robot } = await connected();
    const events = robot.events();
    const command = { action: "fly", height: 3 };
    const later = { ...record(7, "key-0001", { action: "stop" }), action: "fly", command };
    platform.socket.receive({ type: "state", n: 1, record: later });
    expect((await events.next()).value).toMatchObject({ command: { action: "fly", command } });
  });
});

describe("RobotClient", () => {
  it("sends its key in the first message, never in the address", async () => {
    const { platform } = await connected();
    expect(platform.socket.url).not.toContain("drv_");
    expect(platform.socket.sent).toEqual([
      { type: "hello", version: 1, role: "drive", key: "drv_BBBBBBBBBBBBBBBBBBBBBB", sentAt: 0 },
    ]);
  });

  it("sends the role `watch` with a watch key", () => {
    const platform = new FakePlatform();
    const address = ADDRESS.replace("#drv_", "#wch_");
    void RobotClient.connect(address, { platform }).catch(() => undefined);
    platform.socket.open();
    expect(platform.socket.sent).toMatchObject([{ type: "hello", role: "watch" }]);
  });

  it("sends its name", () => {
    const platform = new FakePlatform();
    const name = "Right wall";
    void RobotClient.connect(ADDRESS, { platform, name }).catch(() => undefined);
    platform.socket.open();
    expect(platform.socket.sent).toMatchObject([{ type: "hello", name }]);
  });

  it("ends when the owner blocks it, and does not reconnect", async () => {
    const { platform, robot } = await connected();
    const move = robot.move(10);
    platform.socket.cut(4403);
    await expect(move).rejects.toMatchObject({
      code: "blocked",
      message: expect.stringContaining("blocked this script"),
    });
    const { socket } = platform;
    platform.pass(60_000);
    expect(platform.socket).toBe(socket);
  });

  it("resolves a manoeuvre when the robot has ended it", async () => {
    const { robot, report } = await connected();
    const move = robot.move(120);
    report("ack", 1);
    report("state", 1, { state: "started" });
    report("state", 1, { state: "collided", distance: 80 });
    expect(await move).toMatchObject({ state: "collided", distance: 80 });
  });

  it("resolves an endless motion when the robot has started it", async () => {
    const { robot, report } = await connected();
    const forward = robot.forward();
    report("ack", 1);
    report("state", 1, { state: "started" });
    expect(await forward).toMatchObject({ state: "started" });
  });

  it("sends only the newest of the velocities that were set while disconnected", async () => {
    const { platform, robot, sent, report, welcome } = await connected();
    const before = robot.drive(0.1, 0.1);
    platform.socket.cut(1006);
    const offline = [0.2, 0.3].map((power) => robot.drive(power, power));
    const turn = robot.turn(45);
    const after = [0.4, 0.5].map((power) => robot.drive(power, power));
    platform.pass(10_000);
    welcome();
    expect(sent().map(({ command }) => command)).toMatchObject([{ action: "drive", left: 0.3 }]);
    report("ack", 1);
    report("state", 1, { state: "started" });
    for (const done of [before, ...offline]) {
      expect(await done).toMatchObject({ seq: 1, command: { left: 0.3 } });
    }
    expect(sent().at(-1)).toMatchObject({ command: { action: "turn" } });
    report("ack", 2);
    expect(sent().at(-1)).toMatchObject({ command: { action: "drive", left: 0.5 } });
    report("state", 2, { state: "completed" });
    report("ack", 3, { state: "started" });
    expect(await turn).toMatchObject({ seq: 2 });
    expect(await Promise.all(after)).toMatchObject([{ seq: 3 }, { seq: 3 }]);
  });

  it.each(["cancelled", "superseded", "expired"] as const)(
    "reports why a manoeuvre was %s",
    async (state) => {
      const { platform, robot, report } = await connected();
      const turn = robot.turn(45);
      report("ack", 1);
      platform.pass(10_000);
      report("state", 1, { state, reason: "Command 2 stopped this command." });
      const error = await turn.catch((thrown: unknown) => thrown);
      expect(error).toMatchObject({ code: state, hint: "Command 2 stopped this command." });
      // The sentence contains the code already.
      expect(String(error).split(state)).toHaveLength(2);
    },
  );

  it("sends commands one at a time, each with its own key", async () => {
    const { robot, sent, report } = await connected();
    const both = Promise.all([robot.left90(), robot.right90()]);
    expect(sent()).toHaveLength(1);
    report("ack", 1);
    expect(sent().map(({ command }) => command.action)).toEqual(["left 90", "right 90"]);
    expect(sent()[0]?.key).not.toBe(sent()[1]?.key);
    report("ack", 2);
    report("state", 1, { state: "completed" });
    report("state", 2, { state: "completed" });
    expect((await both).map(({ seq }) => seq)).toEqual([1, 2]);
  });

  it("reconnects with the last state that it received, and resumes from there", async () => {
    const { platform, robot, sent, report, welcome } = await connected();
    const left = robot.left90();
    report("ack", 1);
    report("state", 1, { state: "started" });
    platform.socket.cut(1006);
    platform.pass(10_000);
    welcome();
    expect(platform.socket.sent[0]).toMatchObject({ type: "hello", since: "k3J9x2aB-1" });
    expect(sent()).toEqual([]);
    report("state", 1, { state: "completed" });
    expect(await left).toMatchObject({ state: "completed" });
  });

  it("sends open commands again when states are no longer retained", async () => {
    const { platform, robot, sent, report } = await connected();
    const left = robot.left90();
    report("ack", 1);
    platform.socket.receive({ type: "gap", n: 2_000, open: [] });
    expect(sent()).toHaveLength(2);
    expect(sent()[0]).toEqual(sent()[1]);
    report("ack", 1, { state: "completed", duplicate: true });
    expect(await left).toMatchObject({ state: "completed" });
  });

  it("acknowledges snapshots, so that no old ones queue up", async () => {
    const { platform } = await connected();
    platform.socket.receive({ type: "snapshot", snapshot: snapshotOf({ seq: 41 }) });
    expect(platform.socket.sent.at(-1)).toEqual({ type: "seen", seq: 41 });
    for (const seq of [43, 44]) {
      platform.pass(50);
      platform.socket.receive({ type: "snapshot", snapshot: snapshotOf({ seq }) });
    }
    expect(platform.socket.sent.slice(1)).toEqual([
      { type: "seen", seq: 41 },
      { type: "seen", seq: 44 },
    ]);
  });

  it("acknowledges the snapshot in the welcome on each new connection", async () => {
    const { platform, welcome } = await connected();
    platform.socket.receive({ type: "snapshot", snapshot: snapshotOf({ seq: 41 }) });
    platform.socket.cut(1006);
    platform.pass(10_000);
    welcome("k3J9x2aB", snapshotOf({ seq: 90 }));
    expect(platform.socket.sent.at(-1)).toEqual({ type: "seen", seq: 90 });
  });

  it("sends commands again with the same keys, in order, after a restart of the relay", async () => {
    const { platform, robot, sent, report, welcome } = await connected();
    const all = Promise.all([robot.left90(), robot.right90()]);
    report("ack", 1);
    const keys = sent().map(({ key }) => key);
    platform.socket.cut(1006);
    platform.pass(10_000);
    welcome("another1");
    expect(sent().map(({ key }) => key)).toEqual([keys[0]]);
    report("ack", 1, { state: "completed", duplicate: true });
    expect(sent().map(({ key }) => key)).toEqual(keys);
    report("ack", 2);
    report("state", 2, { state: "completed" });
    expect(await all).toHaveLength(2);
  });

  it("sends a command again with its age and its options", async () => {
    const { platform, robot, sent, report, welcome } = await connected();
    const drive = robot.drive(1, 1, undefined, { ttl: 2_000, replace: true, lease: 300 });
    const order = { action: "drive", left: 1, right: 1, ttl: 2_000, replace: true, lease: 300 };
    expect(sent()[0]?.command).toEqual(order);
    platform.pass(400);
    platform.socket.cut(1006);
    platform.pass(600);
    welcome();
    expect(sent()[0]?.command).toEqual({ ...order, age: 1_000 });
    report("ack", 1, { state: "started" });
    await drive;
  });

  it("resolves a motion with conditions at its end, and never drops one for a newer one", async () => {
    const { robot, sent, report } = await connected();
    const near = { sensor: "front", is: "<=", than: 60 } as const;
    const ended: number[] = [];
    const motions = [
      robot.forward({ until: near }),
      robot.drive(0.2, 0.2, undefined, { until: [near, { goal: true }] }),
      robot.drive(0.1, 0.1, undefined, { until: near }),
    ].map(async (motion) => ended.push((await motion).seq));
    expect(sent()[0]?.command).toEqual({ action: "forward", until: [near] });
    report("ack", 1, { state: "started" });
    report("ack", 2);
    report("ack", 3);
    expect(sent().map(({ command }) => command)).toMatchObject([
      { action: "forward" },
      { left: 0.2, until: [near, { goal: true }] },
      { left: 0.1 },
    ]);
    await Promise.resolve();
    expect(ended).toEqual([]);
    for (const seq of [1, 2, 3]) report("state", seq, { state: "completed" });
    await Promise.all(motions);
    expect(ended).toEqual([1, 2, 3]);
  });

  it("rejects conditions together with a time or a lease", async () => {
    const { robot } = await connected();
    const until = { goal: true } as const;
    for (const motion of [
      robot.drive(0.1, 0.1, 500, { until }),
      robot.drive(0.1, 0.1, undefined, { until, lease: 500 }),
      robot.forward({ until: [] }),
    ]) {
      await expect(motion).rejects.toMatchObject({ code: "bad-command", hint: /until/ });
    }
  });

  it("reports a command as expired if the relay rejects it as too late", async () => {
    const { platform, robot, sent } = await connected();
    const move = robot.move(10);
    platform.pass(10_000);
    platform.socket.receive({ type: "problem", problem: tooLate, key: sent()[0]?.key });
    await expect(move).rejects.toMatchObject({ code: "expired", hint: "d" });
  });

  it("adds the shortest round trip to the age of each command", async () => {
    const platform = new FakePlatform();
    const opening = RobotClient.connect(ADDRESS, { platform });
    platform.pass(100);
    platform.socket.open();
    platform.pass(3_000);
    platform.socket.receive(WELCOME);
    const robot = await opening;
    expect(platform.socket.sent).toMatchObject([{ type: "hello", sentAt: 100 }]);
    const answer = (n: number): void => {
      const key = String(platform.socket.sent.at(-1)?.["key"]);
      const done = record(n, key, { action: "turn 180" }, { state: "completed" });
      platform.socket.receive({ type: "ack", record: done });
    };
    void robot.turn180();
    expect(platform.socket.sent.at(-1)).toMatchObject({ sentAt: 3_100, command: { age: 3_000 } });
    platform.pass(40);
    answer(1);
    void robot.turn180();
    expect(platform.socket.sent.at(-1)).toMatchObject({ sentAt: 3_140, command: { age: 40 } });
    platform.pass(500);
    answer(2);
    void robot.turn180();
    expect(platform.socket.sent.at(-1)).toMatchObject({ command: { age: 40 } });
  });

  it("measures the round trip of each connection", async () => {
    const { platform, robot, sent, report } = await connected();
    const move = robot.move(10);
    platform.socket.cut(1006);
    platform.pass(10_000);
    platform.socket.open();
    platform.pass(2_000);
    platform.socket.receive(WELCOME);
    expect(sent()[0]).toMatchObject({ sentAt: 12_000, command: { age: 14_000 } });
    report("ack", 1, { state: "completed" });
    await move;
  });

  it("retries a command that was wrongly rejected as too late, then reconnects", async () => {
    const { platform, robot, sent, report, welcome } = await connected();
    const move = robot.move(10);
    const refuse = (): void =>
      platform.socket.receive({ type: "problem", problem: tooLate, key: sent().at(-1)?.key });
    platform.pass(20);
    refuse();
    expect(sent().map(({ command }) => command.age)).toEqual([undefined, 20]);
    refuse();
    expect(platform.sockets).toHaveLength(2);
    welcome();
    expect(sent()).toHaveLength(1);
    report("ack", 1, { state: "completed" });
    expect(await move).toMatchObject({ state: "completed" });
    const other = robot.move(10);
    for (let n = 0; n < 2; n++) refuse();
    welcome();
    refuse();
    await expect(other).rejects.toMatchObject({ code: "expired" });
  });

  describe("when the relay accepts a command after long round trips, and it expires too early", () => {
    it("sends it again with a new key, once", async () => {
      const { platform, robot, sent, report } = await connected();
      const move = robot.move(10, { ttl: 400 });
      platform.pass(20);
      report("ack", 1);
      report("state", 1, { state: "expired" });
      const [first, second] = sent();
      expect(second?.command).toMatchObject({ action: "move", distance: 10, age: 20 });
      expect(second?.key).not.toBe(first?.key);
      report("ack", 2);
      report("state", 2, { state: "completed" });
      expect(await move).toMatchObject({ seq: 2, state: "completed" });
      const other = robot.move(10, { ttl: 400 });
      for (const seq of [3, 4]) {
        report("ack", seq);
        report("state", seq, { state: "expired" });
      }
      await expect(other).rejects.toMatchObject({ code: "expired" });
    });

    it("reports the reason if it expired only a round trip too early", async () => {
      const { platform, robot, sent, report } = await connected();
      const move = robot.move(10, { ttl: 400 });
      report("ack", 1);
      platform.pass(390);
      report("state", 1, { state: "expired", reason: "The run is paused." });
      await expect(move).rejects.toMatchObject({ code: "expired", hint: "The run is paused." });
      expect(sent()).toHaveLength(1);
    });

    it("reports it as expired if a later command could overtake it", async () => {
      const { robot, sent, report } = await connected();
      const move = robot.move(10, { ttl: 400 });
      const turn = robot.left90();
      report("ack", 1);
      report("state", 1, { state: "expired" });
      await expect(move).rejects.toMatchObject({ code: "expired" });
      expect(sent()).toHaveLength(2);
      report("ack", 2, { state: "completed" });
      await turn;
    });
  });

  it("sends a stop without the short time to live of other commands", async () => {
    const platform = new FakePlatform();
    const opening = RobotClient.connect(ADDRESS, { platform, ttl: 200 });
    platform.socket.open();
    platform.socket.receive(WELCOME);
    const robot = await opening;
    void robot.stop();
    expect(platform.socket.sent.at(-1)?.["command"]).toEqual({ action: "stop" });
  });

  it("retries after a delay when the relay is busy", async () => {
    const { platform, robot, sent, report } = await connected();
    const move = robot.move(10);
    const problem = { type: "/p", title: "t", status: 429, detail: "d", errors: [] };
    platform.socket.receive({ type: "problem", problem, key: sent()[0]?.key });
    platform.pass(1_000);
    expect(sent()).toHaveLength(2);
    const [first, second] = sent();
    expect(second).toEqual({ ...first, sentAt: 500, command: { ...first?.command, age: 500 } });
    report("ack", 1, { state: "completed" });
    await move;
  });

  it("rejects a command that the relay refuses, and continues with the next", async () => {
    const { platform, robot, sent, report } = await connected();
    const [first, second] = [robot.move(10), robot.move(20)];
    const problem = { type: "/p", title: "No", status: 409, detail: "Use a new key.", errors: [] };
    platform.socket.receive({ type: "problem", problem, key: sent()[0]?.key });
    await expect(first).rejects.toMatchObject({ code: "refused", hint: "Use a new key." });
    report("ack", 1, { state: "completed" });
    await second;
  });

  it.each([
    { name: "NaN", send: (robot: RobotClient) => robot.move(Number.NaN), field: "distance" },
    { name: "too far", send: (robot: RobotClient) => robot.move(1e9), field: "distance" },
    { name: "a power of 2", send: (robot: RobotClient) => robot.drive(2, 0), field: "left" },
  ])("rejects an invalid number before sending it: $name", async ({ send, field }) => {
    const { robot, sent } = await connected();
    await expect(send(robot)).rejects.toMatchObject({
      code: "bad-command",
      hint: expect.stringContaining(field),
    });
    expect(sent()).toEqual([]);
  });

  it.each([
    {
      call: (robot: RobotClient) => robot.forward(100 as never),
      error: "forward() takes no distance (bad-command). Use move(100).",
    },
    {
      call: (robot: RobotClient) => robot.reverse(50 as never),
      error: "reverse() takes no distance (bad-command). Use move(-50).",
    },
    {
      call: (robot: RobotClient) => robot.left90(45 as never),
      error: "left90() takes no angle (bad-command). Use turn(-45).",
    },
    {
      call: (robot: RobotClient) => robot.right90(45 as never),
      error: "right90() takes no angle (bad-command). Use turn(45).",
    },
    {
      call: (robot: RobotClient) => robot.move(100, 50 as never),
      error: "move() takes no second number (bad-command). Use move(100).",
    },
    {
      call: (robot: RobotClient) => robot.stop(1 as never),
      error: "stop() takes no number (bad-command). Use stop().",
    },
    {
      call: (robot: RobotClient) => robot.turn(90, "fast" as never),
      error:
        "turn() does not accept a string as options (bad-command). " +
        "Pass an object, such as { ttl: 2000 }, or nothing.",
    },
    {
      call: (robot: RobotClient) => robot.forward({ distance: 100 } as never),
      error: expect.stringContaining("distance"),
    },
  ])("$call is an error in JavaScript that names the right call", async ({ call, error }) => {
    const { robot, sent } = await connected();
    await expect(call(robot)).rejects.toMatchObject({ code: "bad-command", message: error });
    expect(sent()).toEqual([]);
  });

  it("returns each report once: sensors() waits for a newer one", async () => {
    const { platform, robot } = await connected();
    const first = robot.sensors();
    platform.socket.receive({ type: "snapshot", snapshot: snapshotOf({ seq: 1 }) });
    expect(await first).toEqual(snapshotOf().sensors);
    const second = robot.snapshot();
    platform.socket.receive({ type: "snapshot", snapshot: snapshotOf({ seq: 2 }) });
    platform.socket.receive({ type: "snapshot", snapshot: snapshotOf({ seq: 3 }) });
    expect((await second).seq).toBe(2);
    expect((await robot.snapshot()).seq).toBe(3);
  });

  it("reports the robot as gone if it sends no snapshot", async () => {
    const { platform, robot } = await connected();
    const sensors = robot.sensors();
    platform.pass(20_000);
    platform.socket.receive({ type: "heartbeat" });
    platform.pass(10_000);
    await expect(sensors).rejects.toMatchObject({ code: "robot-gone" });
  });

  it("never returns readings from before the page closed, and names the cause", async () => {
    const { platform, robot } = await connected();
    platform.socket.receive({ type: "snapshot", snapshot: snapshotOf({ seq: 1, state: "gone" }) });
    const sensors = robot.sensors();
    platform.pass(20_000);
    platform.socket.receive({ type: "heartbeat" });
    platform.pass(10_000);
    await expect(sensors).rejects.toMatchObject({
      code: "robot-gone",
      message:
        "The robot's page is closed or not connected (robot-gone). " +
        "Open the page again and choose Remote. If it says Off, press Connect. " +
        "If you closed its tab, copy the new address into the script.",
    });
    const back = robot.snapshot();
    platform.socket.receive({ type: "snapshot", snapshot: snapshotOf({ seq: 2 }) });
    expect(await back).toMatchObject({ seq: 2, state: "running" });
  });

  it("follows the robot until the client is closed", async () => {
    const { platform, robot } = await connected();
    const seen: number[] = [];
    platform.socket.receive({ type: "snapshot", snapshot: snapshotOf({ seq: 1 }) });
    for await (const { seq } of robot.snapshots()) {
      seen.push(seq);
      if (seq === 3) robot.close();
      else platform.socket.receive({ type: "snapshot", snapshot: snapshotOf({ seq: seq + 1 }) });
    }
    expect(seen).toEqual([1, 2, 3]);
  });

  it("receives the last snapshot again when the page closes", async () => {
    const { platform, robot } = await connected();
    const send = (state: "running" | "gone", seq: number): void =>
      platform.socket.receive({ type: "snapshot", snapshot: snapshotOf({ seq, state }) });
    const seen: string[] = [];
    send("running", 1);
    for await (const { seq, state } of robot.snapshots()) {
      seen.push(`${state} ${seq}`);
      if (seq === 2) robot.close();
      else if (state === "gone") send("running", 2);
      else {
        send("running", 1);
        send("gone", 1);
      }
    }
    expect(seen).toEqual(["running 1", "gone 1", "running 2"]);
  });

  it("times out if there is no response", async () => {
    const platform = new FakePlatform();
    const opening = RobotClient.connect(ADDRESS, { platform, answerTimeout: 5_000 });
    platform.pass(5_000);
    await expect(opening).rejects.toMatchObject({ code: "timeout" });
    const { platform: open, robot } = await connected();
    const move = robot.move(10);
    open.pass(30_000);
    await expect(move).rejects.toMatchObject({ code: "timeout" });
  });

  it.each([
    { code: 4401, error: "not-authorised" },
    { code: 4404, error: "no-robot" },
    { code: 4410, error: "no-robot" },
  ])("reports close code $code as $error, to everyone who waits", async ({ code, error }) => {
    const { platform, robot } = await connected();
    const move = robot.move(10);
    const sensors = robot.sensors();
    platform.socket.cut(code);
    await expect(move).rejects.toMatchObject({ code: error });
    await expect(sensors).rejects.toMatchObject({ code: error });
    await expect(robot.move(10)).rejects.toMatchObject({ code: error });
  });

  it("names a wrong id and what to check", async () => {
    const platform = new FakePlatform();
    const opening = RobotClient.connect(ADDRESS, { platform });
    platform.socket.cut(4404);
    await expect(opening).rejects.toMatchObject({
      message: expect.stringMatching(
        /^No robot has the id A{22} \(no-robot\)\. Check the id for typing errors/,
      ),
    });
  });

  it("names the button that copies the key after a wrong one", async () => {
    const platform = new FakePlatform();
    const opening = RobotClient.connect(ADDRESS, { platform });
    platform.socket.cut(4401);
    await expect(opening).rejects.toMatchObject({
      message: expect.stringMatching(
        /^The robot rejects this key .*press 'Copy address with key' under Remote/,
      ),
    });
  });

  it("refuses a command by a watch link, and continues to read", async () => {
    const platform = new FakePlatform();
    const address = ADDRESS.replace("#drv_", "#wch_");
    const opening = RobotClient.connect(address, { platform });
    platform.socket.open();
    platform.socket.receive(WELCOME);
    const robot = await opening;
    await expect(robot.move(100)).rejects.toMatchObject({
      code: "not-authorised",
      message: expect.stringMatching(/^This is a watch link: it can only read .*Copy address/),
    });
    const sensors = robot.sensors();
    platform.socket.receive({ type: "snapshot", snapshot: snapshotOf({ seq: 1 }) });
    expect(await sensors).toEqual(snapshotOf().sensors);
  });

  it("rejects open commands when it is closed", async () => {
    const { platform, robot } = await connected();
    const move = robot.move(10);
    robot.close();
    await expect(move).rejects.toMatchObject({ code: "closed", hint: CLOSED });
    expect(platform.socket.isClosed).toBe(true);
    await expect(robot.move(10)).rejects.toMatchObject({ code: "closed", hint: CLOSED });
  });
});
