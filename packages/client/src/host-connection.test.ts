import { snapshotOf } from "@corridor/protocol/testing";
import type { AliveDriver, CommandState, DeliveredCommand } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { HostConnection, type HostConnectionOptions, type HostStatus } from "./host-connection.ts";
import { FakePlatform } from "./testing/fake-platform.ts";
import { record } from "./testing/messages.ts";

const done = { state: "completed" as const, reason: null, pose: null, distance: 100 };
const command = (seq: number) => ({
  type: "command",
  at: 0,
  seq,
  key: null,
  command: { action: "left 90" },
  acceptedAt: "2026-01-01T00:00:00.000Z",
  driver: "Zx81qP",
  ttl: 10_000,
  remaining: 10_000,
  replace: false,
  lease: null,
});
const recordOf = (seq: number, state: CommandState) =>
  record(seq, "key-0001", { action: "left 90" }, { state });

function host(
  start: Partial<Pick<HostConnectionOptions, "lastApplied" | "fresh" | "endings" | "save">> = {},
) {
  const platform = new FakePlatform();
  const commands: number[] = [];
  const stops: DeliveredCommand[] = [];
  const statuses: HostStatus[] = [];
  const calls: string[] = [];
  const delivered: DeliveredCommand[] = [];
  const alive: AliveDriver[] = [];
  const connection = new HostConnection({
    origin: "http://localhost:8080",
    credentials: { id: "AAAAAAAAAAAAAAAAAAAAAA", ownerKey: "own_CCCCCCCCCCCCCCCCCCCCCC" },
    lastApplied: 0,
    fresh: false,
    ...start,
    snapshot: () => snapshotOf(),
    onCommand: (each) => {
      delivered.push(each);
      commands.push(each.seq);
    },
    onStop: (stop) => {
      stops.push(stop);
      for (const seq of commands) connection.ended(seq, { ...done, state: "cancelled" });
    },
    onCancel: (seq) => calls.push(`cancel ${seq}`),
    onGiveBack: () => calls.push("give back"),
    onYield: () => calls.push("yield"),
    onState: ({ seq, state }, ttl) => calls.push(`${seq} ${state} within ${ttl}`),
    onRefused: ({ seq, state }) => calls.push(`${seq} was ${state}`),
    onStored: (seq) => calls.push(`${seq} stored`),
    onStatus: (status) => statuses.push(status),
    onDrivers: (_drivers, scripts) => alive.push(...scripts),
    platform,
  });
  const welcome = (epoch = 1): void => {
    platform.socket.open();
    platform.socket.receive({ type: "welcome", version: 1, epoch, at: 0 });
  };
  const reconnect = (epoch: number): void => {
    platform.socket.cut(1006);
    platform.pass(10_000);
    welcome(epoch);
  };
  return {
    platform,
    connection,
    commands,
    stops,
    statuses,
    calls,
    delivered,
    alive,
    welcome,
    reconnect,
  };
}

describe("HostConnection", () => {
  it("sends its key and its progress first", () => {
    const { platform, connection, welcome, statuses } = host({ lastApplied: 7, fresh: true });
    welcome();
    expect(platform.socket.sent).toEqual([
      { type: "hello", version: 1, role: "own", key: "own_CCCCCCCCCCCCCCCCCCCCCC" },
      {
        type: "resume",
        lastApplied: 7,
        fresh: true,
        page: expect.stringMatching(/^[0-9a-z]{10}$/),
        endings: [],
        snapshot: snapshotOf(),
      },
    ]);
    expect(connection.isConnected).toBe(true);
    expect(statuses.map(({ kind }) => kind)).toEqual(["connecting", "connected"]);
  });

  it("sends a snapshot before an ending, so that readers have fresh sensor values", () => {
    const { platform, connection, welcome } = host();
    welcome(3);
    platform.socket.receive(command(1));
    connection.started(1);
    connection.ended(1, done);
    expect(platform.socket.sent.slice(2).map(({ type, epoch }) => [type, epoch])).toEqual([
      ["started", 3],
      ["snapshot", 3],
      ["ended", 3],
    ]);
  });

  it("sends endings again after reconnects until they are stored", () => {
    const { platform, connection, calls, welcome, reconnect } = host();
    welcome();
    platform.socket.receive(command(1));
    platform.socket.receive(command(2));
    connection.started(1);
    connection.ended(1, done);
    platform.socket.cut(1006);
    connection.started(2);
    platform.pass(10_000);
    welcome(2);
    expect(platform.socket.sent[1]).toEqual({
      type: "resume",
      lastApplied: 2,
      fresh: false,
      page: expect.any(String),
      endings: [{ seq: 1, ...done }],
      // Readers of that ending have fresh sensor values.
      snapshot: snapshotOf(),
    });
    expect(calls).not.toContain("1 stored");
    platform.socket.receive({ type: "stored", seq: 1 });
    expect(calls).toContain("1 stored");
    reconnect(3);
    expect(platform.socket.sent[1]).toMatchObject({ lastApplied: 2, endings: [] });
  });

  it("identifies its page on each connection", () => {
    const { platform, welcome, reconnect } = host();
    welcome();
    const [, { page: name } = {}] = platform.socket.sent;
    reconnect(2);
    expect(platform.socket.sent[1]).toMatchObject({ type: "resume", page: name });
    expect(name).toBeTypeOf("string");
  });

  it("releases the robot to another page: starts nothing, and first reports what it had started", () => {
    const { platform, connection, commands, calls, welcome, reconnect } = host();
    welcome(3);
    for (const seq of [1, 2]) platform.socket.receive(command(seq));
    connection.started(1);
    calls.length = 0;
    platform.socket.receive({ type: "yield" });
    platform.socket.receive(command(3));
    expect(calls).toEqual(["give back", "yield"]);
    expect(commands).toEqual([1, 2]);
    expect(platform.socket.sent.slice(2)).toEqual([
      { type: "started", epoch: 3, seq: 1 },
      { type: "yielded", epoch: 3 },
    ]);
    // The other page disconnects before it owns the robot: this one owns it again.
    reconnect(4);
    for (const seq of [2, 3]) platform.socket.receive(command(seq));
    expect(commands).toEqual([1, 2, 2, 3]);
  });

  it("never passes on a started command again, and repeats its reports", () => {
    const { platform, connection, commands, welcome, reconnect } = host();
    welcome();
    for (const seq of [1, 2, 3]) platform.socket.receive(command(seq));
    connection.started(1);
    connection.ended(1, done);
    connection.started(2);
    reconnect(2);
    for (const seq of [1, 2, 3, 4]) platform.socket.receive(command(seq));
    expect(commands).toEqual([1, 2, 3, 3, 4]);
    expect(platform.socket.sent.slice(2)).toEqual([
      { type: "snapshot", epoch: 2, snapshot: snapshotOf() },
      { type: "ended", epoch: 2, seq: 1, ...done },
      { type: "started", epoch: 2, seq: 2 },
    ]);
  });

  it("reconnects at once on request, and still passes on each command once", () => {
    const { platform, connection, commands, statuses, welcome } = host();
    welcome();
    for (const seq of [1, 2, 3]) platform.socket.receive(command(seq));
    connection.started(1);
    platform.socket.cut(1006);
    connection.open();
    connection.open();
    expect(platform.sockets).toHaveLength(2);
    expect(statuses.map(({ kind }) => kind).slice(-2)).toEqual(["lost", "connecting"]);
    welcome(2);
    for (const seq of [2, 3, 4]) platform.socket.receive(command(seq));
    connection.open();
    // Neither the interrupted delay nor `open` while connected opens another one.
    platform.pass(5_000);
    expect(platform.sockets).toHaveLength(2);
    expect(connection.isConnected).toBe(true);
    expect(commands).toEqual([1, 2, 3, 2, 3, 4]);
  });

  it("sends endings from while it was closed once it is opened again", () => {
    const { platform, connection, commands, welcome } = host();
    welcome();
    for (const seq of [1, 2]) platform.socket.receive(command(seq));
    connection.started(1);
    platform.socket.cut(1006);
    for (const seq of [1, 2]) connection.ended(seq, { ...done, state: "cancelled" });
    connection.close();
    platform.pass(60_000);
    expect(platform.sockets).toHaveLength(1);
    connection.open();
    welcome(2);
    for (const seq of [1, 2, 3]) platform.socket.receive(command(seq));
    expect(platform.socket.sent[1]).toMatchObject({
      lastApplied: 2,
      fresh: false,
      endings: [
        { seq: 1, state: "cancelled" },
        { seq: 2, state: "cancelled" },
      ],
    });
    expect(commands).toEqual([1, 2, 3]);
  });

  it("returns unstarted commands on each reconnect, before it reports its progress", () => {
    const { platform, connection, calls, welcome, reconnect } = host();
    welcome();
    for (const seq of [1, 2, 3]) platform.socket.receive(command(seq));
    connection.started(1);
    expect(calls).toEqual(["give back"]);
    reconnect(2);
    expect(calls).toEqual(["give back", "give back"]);
    expect(platform.socket.sent[1]).toMatchObject({ lastApplied: 1 });
  });

  it("reports only the ending of a command that ended early, and never accepts it again", () => {
    const { platform, connection, commands, welcome, reconnect } = host();
    welcome();
    for (const seq of [1, 2, 3]) platform.socket.receive(command(seq));
    connection.started(1);
    connection.ended(3, { ...done, state: "expired" });
    expect(connection.lastApplied).toBe(1);
    reconnect(2);
    expect(platform.socket.sent[1]).toMatchObject({ lastApplied: 1, endings: [{ seq: 3 }] });
    platform.socket.receive({ type: "stored", seq: 3 });
    platform.socket.receive(command(2));
    platform.socket.receive(command(3));
    connection.started(2);
    expect(commands).toEqual([1, 2, 3, 2]);
    expect(connection.lastApplied).toBe(2);
    platform.socket.receive(command(4));
    connection.started(4);
    expect(connection.lastApplied).toBe(4);
  });

  it("passes on cancellations, waiting commands, and endings that were too late", () => {
    const { platform, connection, calls, welcome, reconnect } = host();
    welcome();
    platform.socket.receive(command(1));
    platform.socket.receive({ type: "cancel", seq: 1, cause: "sender" });
    platform.socket.receive({ type: "state", record: recordOf(2, "expired"), ttl: 400 });
    connection.ended(1, done);
    platform.socket.receive({ type: "refused", record: recordOf(1, "cancelled") });
    expect(calls.slice(1)).toEqual(["cancel 1", "2 expired within 400", "1 was cancelled"]);
    reconnect(2);
    expect(platform.socket.sent[1]).toMatchObject({ endings: [] });
  });

  it("does not trust a delayed welcome, and requests the relay's time until a response is fast", () => {
    const { platform, delivered } = host();
    const requests = () => platform.socket.sent.filter(({ type }) => type === "time");
    platform.socket.open();
    platform.pass(3_000);
    platform.socket.receive({ type: "welcome", version: 1, epoch: 4, at: 0 });
    platform.socket.receive({ ...command(1), at: 0, remaining: 2_000 });
    expect(requests()).toEqual([{ type: "time", epoch: 4 }]);
    platform.pass(20);
    platform.socket.receive({ type: "time", at: 3_010 });
    platform.socket.receive({ ...command(2), at: 3_010, remaining: 2_000 });
    const scripts = { connected: 1, client: "Python", silentMs: 0, alive: [] };
    platform.socket.receive({
      type: "drivers",
      at: 3_010,
      scripts: [],
      paused: false,
      mayReset: true,
      ...scripts,
    });
    expect(delivered.map(({ remaining }) => remaining)).toEqual([0, 1_990]);
    expect(requests()).toHaveLength(1);
  });

  it("subtracts the transit time of commands and of the state of scripts", () => {
    const { platform, delivered, alive, welcome } = host();
    welcome();
    platform.pass(3_000);
    platform.socket.receive({ ...command(1), at: 2_000 });
    platform.socket.receive({ ...command(2), at: 2_900, remaining: 50 });
    const scripts = [{ driver: "Zx81qP", silentMs: 100, connectionMs: null }];
    const drivers = { connected: 1, client: "Python", silentMs: 100 };
    platform.socket.receive({
      type: "drivers",
      ...drivers,
      alive: scripts,
      scripts: [],
      paused: false,
      mayReset: true,
      at: 1_500,
    });
    expect(delivered.map(({ remaining }) => remaining)).toEqual([9_000, 0]);
    expect(alive).toEqual([{ driver: "Zx81qP", silentMs: 1_600, connectionMs: null }]);
  });

  it("does not pass on commands from before a reload", () => {
    const { platform, commands, welcome } = host({ lastApplied: 5, fresh: true });
    welcome();
    platform.socket.receive(command(5));
    platform.socket.receive(command(6));
    expect(commands).toEqual([6]);
  });

  it("uses the new epoch as soon as it reports `connected`", () => {
    const { platform, connection, statuses, welcome, reconnect } = host();
    const push = statuses.push.bind(statuses);
    statuses.push = (status) => {
      if (status.kind === "connected") connection.sendSnapshot(snapshotOf());
      return push(status);
    };
    welcome(1);
    expect(platform.socket.sent.at(-1)).toMatchObject({ type: "snapshot", epoch: 1 });
    reconnect(2);
    expect(platform.socket.sent.at(-1)).toMatchObject({ type: "snapshot", epoch: 2 });
  });

  it("sends endings from between `hello` and welcome", () => {
    const { platform, connection, welcome } = host();
    welcome();
    platform.socket.receive(command(1));
    platform.socket.cut(1006);
    platform.pass(10_000);
    platform.socket.open();
    connection.started(1);
    connection.ended(1, done);
    expect(platform.socket.sent).toHaveLength(2);
    platform.socket.receive({ type: "welcome", version: 1, epoch: 2, at: 0 });
    expect(platform.socket.sent.slice(-2)).toMatchObject([
      { type: "snapshot", epoch: 2 },
      { type: "ended", seq: 1, epoch: 2 },
    ]);
  });

  it("ends a stop itself, after all other commands", () => {
    const { platform, connection, stops, welcome } = host();
    welcome();
    platform.socket.receive(command(1));
    platform.socket.receive({ ...command(2), type: "stop", command: { action: "stop" } });
    expect(stops).toHaveLength(1);
    const endings = platform.socket.sent.filter(({ type }) => type === "ended");
    expect(endings.map(({ seq, state }) => [seq, state])).toEqual([
      [1, "cancelled"],
      [2, "completed"],
    ]);
    expect(connection.lastApplied).toBe(2);
  });

  it.each([
    { code: 4409, kind: "replaced" },
    { code: 4404, kind: "over" },
    { code: 4410, kind: "over" },
    { code: 4401, kind: "over" },
  ])("gives up for good after close code $code", ({ code, kind }) => {
    const { platform, connection, statuses, welcome } = host();
    welcome();
    platform.socket.cut(code);
    platform.pass(60_000);
    connection.open();
    expect(platform.sockets).toHaveLength(1);
    expect(statuses.at(-1)).toMatchObject({ kind, reason: { code } });
  });

  it("reconnects after random delays with a limit that doubles from 0.25 to 10 s", () => {
    const { platform, statuses } = host();
    platform.luck = 0.999;
    for (let n = 0; n < 8; n++) {
      platform.socket.cut(1006);
      platform.pass(10_000);
    }
    const pauses = statuses.flatMap((status) => (status.kind === "lost" ? [status.retryMs] : []));
    const limits = [250, 500, 1_000, 2_000, 4_000, 8_000, 10_000, 10_000];
    expect(pauses.map((pause) => Math.round(pause / 0.999))).toEqual(limits);
  });

  it("does not wait long after a short outage, after any number of short delays", () => {
    const { platform, statuses } = host();
    const pauses: number[] = [];
    for (const luck of [0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.999]) {
      platform.luck = luck;
      platform.socket.cut(1006);
      const status = statuses.at(-1);
      if (status?.kind !== "lost") throw new Error("the connection is not lost");
      pauses.push(status.retryMs);
      platform.pass(status.retryMs);
    }
    const lostMs = pauses.slice(0, -1).reduce((sum, pause) => sum + pause, 0);
    expect(lostMs).toBeLessThan(250);
    expect(pauses.at(-1)).toBeLessThan(500);
  });

  it("treats silence and a missing welcome as a lost connection", () => {
    const { platform, statuses, welcome } = host();
    platform.pass(10_000);
    expect(statuses.at(-1)?.kind).toBe("lost");
    platform.pass(10_000);
    welcome();
    platform.pass(44_000);
    platform.socket.receive({ type: "heartbeat" });
    platform.pass(44_000);
    expect(statuses.at(-1)?.kind).toBe("connected");
    platform.pass(1_001);
    expect(statuses.at(-1)?.kind).toBe("lost");
  });

  it("ignores unknown messages of the relay", () => {
    const { platform, commands, welcome } = host();
    welcome();
    for (const text of ["", "null", "{", '{"type":"dance"}', '{"type":"command","seq":-1}']) {
      platform.socket.receiveText(text);
    }
    platform.socket.receive(command(1));
    expect(commands).toEqual([1]);
  });
});

/** A page whose world is stored when the test calls `saved`. */
function savingHost() {
  const saves: (() => void)[] = [];
  const save = () => new Promise<void>((resolve) => void saves.push(resolve));
  const page = host({ save });
  page.welcome();
  const sent = () => page.platform.socket.sent.slice(2).filter(({ type }) => type !== "snapshot");
  const saved = async () => {
    for (const resolve of saves.splice(0)) resolve();
    for (let n = 0; n < 5; n++) await Promise.resolve();
  };
  return { ...page, sent, saved };
}

describe("HostConnection with a stored world", () => {
  it("sends an ending once its world is stored, and later messages after it", async () => {
    const { platform, connection, sent, saved } = savingHost();
    platform.socket.receive(command(1));
    platform.socket.receive(command(2));
    connection.started(1);
    connection.ended(1, done);
    connection.started(2);
    expect(sent()).toMatchObject([{ type: "started", seq: 1 }]);
    expect(connection.journal).toEqual({ lastApplied: 2, endings: [{ seq: 1, ...done }] });
    await saved();
    expect(sent().slice(1)).toMatchObject([
      { type: "ended", seq: 1 },
      { type: "started", seq: 2 },
    ]);
  });

  it("does not report an ending that is not stored when it reconnects", async () => {
    const { platform, connection, reconnect, saved, sent } = savingHost();
    platform.socket.receive(command(1));
    connection.started(1);
    connection.ended(1, done);
    reconnect(2);
    expect(platform.socket.sent[1]).toMatchObject({ lastApplied: 1, endings: [] });
    expect(sent()).toEqual([]);
    await saved();
    expect(sent()).toMatchObject([{ type: "ended", seq: 1, epoch: 2 }]);
  });

  it("closes, and releases the robot, after earlier endings", async () => {
    const { platform, connection, saved, sent } = savingHost();
    platform.socket.receive(command(1));
    connection.started(1);
    platform.socket.receive({ type: "yield" });
    connection.ended(1, { ...done, state: "cancelled" });
    connection.close();
    expect(platform.socket.isClosed).toBe(false);
    expect(connection.isConnected).toBe(false);
    await saved();
    expect(sent().map(({ type }) => type)).toContain("ended");
    expect(platform.socket.isClosed).toBe(true);
  });

  it("reconnects if it is opened again before these are stored: it has ignored messages", async () => {
    const { platform, connection, commands, welcome, saved, sent } = savingHost();
    platform.socket.receive(command(1));
    connection.started(1);
    connection.ended(1, done);
    connection.close();
    platform.socket.receive(command(2));
    connection.open();
    expect(platform.sockets.map(({ isClosed }) => isClosed)).toEqual([true, false]);
    welcome(2);
    platform.socket.receive(command(2));
    await saved();
    expect(sent().at(-1)).toMatchObject({ type: "ended", seq: 1, epoch: 2 });
    expect(commands).toEqual([1, 2]);
    expect(connection.isConnected).toBe(true);
  });

  it("disconnects permanently when another page has claimed the world", async () => {
    const { platform, connection, statuses, saved, sent } = savingHost();
    platform.socket.receive(command(1));
    connection.started(1);
    connection.ended(1, done);
    connection.worldClaimed();
    await saved();
    expect(sent()).toMatchObject([{ type: "started" }]);
    expect(platform.socket.isClosed).toBe(true);
    expect(statuses.at(-1)?.kind).toBe("replaced");
    connection.open();
    expect(platform.sockets).toHaveLength(1);
  });

  it("sends the endings of the restored world until the relay has stored them", () => {
    const endings = [{ seq: 6, ...done }];
    const { platform, connection, welcome } = host({ lastApplied: 7, fresh: true, endings });
    welcome();
    expect(platform.socket.sent[1]).toMatchObject({ lastApplied: 7, fresh: true, endings });
    platform.socket.receive({ type: "stored", seq: 6 });
    expect(connection.journal).toEqual({ lastApplied: 7, endings: [] });
  });
});
