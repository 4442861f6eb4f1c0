import { snapshotOf } from "@corridor/protocol/testing";
import { termsOf, type CommandRecord, type Order, type Snapshot } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { RobotClient } from "./robot-client.ts";
import { FakePlatform } from "./testing/fake-platform.ts";
import { ADDRESS, record } from "./testing/messages.ts";

const WELCOME = { type: "welcome", version: 1, stream: "k3J9x2aB", n: 0, snapshot: null };
const tooLate = {
  type: "/problems/too-late",
  title: "Late",
  status: 422,
  detail: "d",
  errors: [],
};

async function connected() {
  const platform = new FakePlatform();
  /** of the newest state */
  let n = 0;
  const opening = RobotClient.connect(ADDRESS, { platform });
  const welcome = (stream = "k3J9x2aB", snapshot: Snapshot | null = null): void => {
    platform.socket.open();
    platform.socket.receive({ type: "welcome", version: 1, stream, n, snapshot });
  };
  welcome();
  const robot = await opening;
  /** What was sent since the greeting of the newest socket. */
  const sent = () =>
    platform.socket.sent.filter(({ type }) => type === "command") as unknown as {
      key: string;
      sentAt: number;
      command: Order;
    }[];
  const tell = (type: "ack" | "state", seq: number, change: Partial<CommandRecord> = {}): void => {
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
  return { platform, robot, sent, tell, welcome };
}

describe("RobotClient", () => {
  it("sends its key in the first message, never in the address", async () => {
    const { platform } = await connected();
    expect(platform.socket.url).not.toContain("drv_");
    expect(platform.socket.sent).toEqual([
      { type: "hello", version: 1, role: "drive", key: "drv_BBBBBBBBBBBBBBBBBBBBBB", sentAt: 0 },
    ]);
  });

  it("says that it only looks on where its key is for watching", () => {
    const platform = new FakePlatform();
    const address = ADDRESS.replace("#drv_", "#wch_");
    void RobotClient.connect(address, { platform }).catch(() => undefined);
    platform.socket.open();
    expect(platform.socket.sent).toMatchObject([{ type: "hello", role: "watch" }]);
  });

  it("says its name where it is given one", () => {
    const platform = new FakePlatform();
    const name = "Right wall";
    void RobotClient.connect(ADDRESS, { platform, name }).catch(() => undefined);
    platform.socket.open();
    expect(platform.socket.sent).toMatchObject([{ type: "hello", name }]);
  });

  it("is over where its owner has sent it away, and does not come again by itself", async () => {
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

  it("keeps the promise of a manoeuvre when the robot has ended it", async () => {
    const { robot, tell } = await connected();
    const move = robot.move(120);
    tell("ack", 1);
    tell("state", 1, { state: "started" });
    tell("state", 1, { state: "collided", distance: 80 });
    expect(await move).toMatchObject({ state: "collided", distance: 80 });
  });

  it("keeps the promise of a motion without an end when the robot has begun", async () => {
    const { robot, tell } = await connected();
    const forward = robot.forward();
    tell("ack", 1);
    tell("state", 1, { state: "started" });
    expect(await forward).toMatchObject({ state: "started" });
  });

  it("sends of the velocities that came while the line was down only the newest", async () => {
    const { platform, robot, sent, tell, welcome } = await connected();
    const before = robot.drive(0.1, 0.1);
    platform.socket.cut(1006);
    const wished = [0.2, 0.3].map((power) => robot.drive(power, power));
    const turn = robot.turn(45);
    const after = [0.4, 0.5].map((power) => robot.drive(power, power));
    platform.pass(10_000);
    welcome();
    expect(sent().map(({ command }) => command)).toMatchObject([{ action: "drive", left: 0.3 }]);
    tell("ack", 1);
    tell("state", 1, { state: "started" });
    for (const done of [before, ...wished]) {
      expect(await done).toMatchObject({ seq: 1, command: { left: 0.3 } });
    }
    expect(sent().at(-1)).toMatchObject({ command: { action: "turn" } });
    tell("ack", 2);
    expect(sent().at(-1)).toMatchObject({ command: { action: "drive", left: 0.5 } });
    tell("state", 2, { state: "completed" });
    tell("ack", 3, { state: "started" });
    expect(await turn).toMatchObject({ seq: 2 });
    expect(await Promise.all(after)).toMatchObject([{ seq: 3 }, { seq: 3 }]);
  });

  it.each(["cancelled", "superseded", "expired"] as const)(
    "says why a manoeuvre was %s",
    async (state) => {
      const { robot, tell } = await connected();
      const turn = robot.turn(45);
      tell("ack", 1);
      tell("state", 1, { state, reason: "stopped by command 2" });
      const error = await turn.catch((thrown: unknown) => thrown);
      expect(error).toMatchObject({ code: state, hint: "stopped by command 2" });
      // The code is a word of the sentence already.
      expect(String(error).split(state)).toHaveLength(2);
    },
  );

  it("sends commands one after the other, each with its own key", async () => {
    const { robot, sent, tell } = await connected();
    const both = Promise.all([robot.left90(), robot.right90()]);
    expect(sent()).toHaveLength(1);
    tell("ack", 1);
    expect(sent().map(({ command }) => command.action)).toEqual(["left 90", "right 90"]);
    expect(sent()[0]?.key).not.toBe(sent()[1]?.key);
    tell("ack", 2);
    tell("state", 1, { state: "completed" });
    tell("state", 2, { state: "completed" });
    expect((await both).map(({ seq }) => seq)).toEqual([1, 2]);
  });

  it("comes back with the last state that it was told, and goes on from there", async () => {
    const { platform, robot, sent, tell, welcome } = await connected();
    const left = robot.left90();
    tell("ack", 1);
    tell("state", 1, { state: "started" });
    platform.socket.cut(1006);
    platform.pass(10_000);
    welcome();
    expect(platform.socket.sent[0]).toMatchObject({ type: "hello", since: "k3J9x2aB-1" });
    expect(sent()).toEqual([]);
    tell("state", 1, { state: "completed" });
    expect(await left).toMatchObject({ state: "completed" });
  });

  it("asks again for what is open when states are not kept any more", async () => {
    const { platform, robot, sent, tell } = await connected();
    const left = robot.left90();
    tell("ack", 1);
    platform.socket.receive({ type: "gap", n: 2_000, open: [] });
    expect(sent()).toHaveLength(2);
    expect(sent()[0]).toEqual(sent()[1]);
    tell("ack", 1, { state: "completed", duplicate: true });
    expect(await left).toMatchObject({ state: "completed" });
  });

  it("tells the relay what it has seen, so that no old snapshots wait for it", async () => {
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

  it("says on each new line that it has read what came with the welcome", async () => {
    const { platform, welcome } = await connected();
    platform.socket.receive({ type: "snapshot", snapshot: snapshotOf({ seq: 41 }) });
    platform.socket.cut(1006);
    platform.pass(10_000);
    welcome("k3J9x2aB", snapshotOf({ seq: 90 }));
    expect(platform.socket.sent.at(-1)).toEqual({ type: "seen", seq: 90 });
  });

  it("asks again with the same keys, in order, when the relay was restarted", async () => {
    const { platform, robot, sent, tell, welcome } = await connected();
    const all = Promise.all([robot.left90(), robot.right90()]);
    tell("ack", 1);
    const keys = sent().map(({ key }) => key);
    platform.socket.cut(1006);
    platform.pass(10_000);
    welcome("another1");
    expect(sent().map(({ key }) => key)).toEqual([keys[0]]);
    tell("ack", 1, { state: "completed", duplicate: true });
    expect(sent().map(({ key }) => key)).toEqual(keys);
    tell("ack", 2);
    tell("state", 2, { state: "completed" });
    expect(await all).toHaveLength(2);
  });

  it("says how old a command is that it sends again, and what was wished of it", async () => {
    const { platform, robot, sent, tell, welcome } = await connected();
    const drive = robot.drive(1, 1, undefined, { ttl: 2_000, replace: true, lease: 300 });
    const order = { action: "drive", left: 1, right: 1, ttl: 2_000, replace: true, lease: 300 };
    expect(sent()[0]?.command).toEqual(order);
    platform.pass(400);
    platform.socket.cut(1006);
    platform.pass(600);
    welcome();
    expect(sent()[0]?.command).toEqual({ ...order, age: 1_000 });
    tell("ack", 1, { state: "started" });
    await drive;
  });

  it("says that a command is too old when the relay refuses it for that", async () => {
    const { platform, robot, sent } = await connected();
    const move = robot.move(10);
    platform.pass(10_000);
    platform.socket.receive({ type: "problem", problem: tooLate, key: sent()[0]?.key });
    await expect(move).rejects.toMatchObject({ code: "expired", hint: "d" });
  });

  it("adds the smallest round trip to the age of each command, for it may all have been the way there", async () => {
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

  it("measures each new connection anew", async () => {
    const { platform, robot, sent, tell } = await connected();
    const move = robot.move(10);
    platform.socket.cut(1006);
    platform.pass(10_000);
    platform.socket.open();
    platform.pass(2_000);
    platform.socket.receive(WELCOME);
    expect(sent()[0]).toMatchObject({ sentAt: 12_000, command: { age: 14_000 } });
    tell("ack", 1, { state: "completed" });
    await move;
  });

  it("tries a command again that was refused as too late although it is not, then by a new connection", async () => {
    const { platform, robot, sent, tell, welcome } = await connected();
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
    tell("ack", 1, { state: "completed" });
    expect(await move).toMatchObject({ state: "completed" });
    const other = robot.move(10);
    for (let n = 0; n < 2; n++) refuse();
    welcome();
    refuse();
    await expect(other).rejects.toMatchObject({ code: "expired" });
  });

  it("lets a stop have its own time to live, however short that of the other commands is", async () => {
    const platform = new FakePlatform();
    const opening = RobotClient.connect(ADDRESS, { platform, ttl: 200 });
    platform.socket.open();
    platform.socket.receive(WELCOME);
    const robot = await opening;
    void robot.stop();
    expect(platform.socket.sent.at(-1)?.["command"]).toEqual({ action: "stop" });
  });

  it("waits a moment and sends again when the relay is busy", async () => {
    const { platform, robot, sent, tell } = await connected();
    const move = robot.move(10);
    const problem = { type: "/p", title: "t", status: 429, detail: "d", errors: [] };
    platform.socket.receive({ type: "problem", problem, key: sent()[0]?.key });
    platform.pass(1_000);
    expect(sent()).toHaveLength(2);
    const [first, second] = sent();
    expect(second).toEqual({ ...first, sentAt: 500, command: { ...first?.command, age: 500 } });
    tell("ack", 1, { state: "completed" });
    await move;
  });

  it("rejects what the relay refuses, and goes on with the next", async () => {
    const { platform, robot, sent, tell } = await connected();
    const [first, second] = [robot.move(10), robot.move(20)];
    const problem = { type: "/p", title: "No", status: 409, detail: "Use a new key.", errors: [] };
    platform.socket.receive({ type: "problem", problem, key: sent()[0]?.key });
    await expect(first).rejects.toMatchObject({ code: "refused", hint: "Use a new key." });
    tell("ack", 1, { state: "completed" });
    await second;
  });

  it.each([
    { name: "NaN", ask: (robot: RobotClient) => robot.move(Number.NaN), field: "distance" },
    { name: "too far", ask: (robot: RobotClient) => robot.move(1e9), field: "distance" },
    { name: "a power of 2", ask: (robot: RobotClient) => robot.drive(2, 0), field: "left" },
  ])("refuses a wrong number before it is sent: $name", async ({ ask, field }) => {
    const { robot, sent } = await connected();
    await expect(ask(robot)).rejects.toMatchObject({
      code: "bad-command",
      hint: expect.stringContaining(field),
    });
    expect(sent()).toEqual([]);
  });

  it("gives each report once: sensors() waits for a newer one", async () => {
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

  it("says that the robot is gone when no report comes", async () => {
    const { platform, robot } = await connected();
    const sensors = robot.sensors();
    platform.pass(20_000);
    platform.socket.receive({ type: "heartbeat" });
    platform.pass(10_000);
    await expect(sensors).rejects.toMatchObject({ code: "robot-gone" });
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

  it("reads that the page is closed, which comes with the last snapshot once more", async () => {
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

  it("gives up in time when nobody answers", async () => {
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
  ])("tells close code $code as $error, to everyone who waits", async ({ code, error }) => {
    const { platform, robot } = await connected();
    const move = robot.move(10);
    const sensors = robot.sensors();
    platform.socket.cut(code);
    await expect(move).rejects.toMatchObject({ code: error });
    await expect(sensors).rejects.toMatchObject({ code: error });
    await expect(robot.move(10)).rejects.toMatchObject({ code: error });
  });

  it("rejects what is open when it is closed", async () => {
    const { platform, robot } = await connected();
    const move = robot.move(10);
    robot.close();
    await expect(move).rejects.toMatchObject({ code: "closed" });
    expect(platform.socket.isClosed).toBe(true);
  });
});
