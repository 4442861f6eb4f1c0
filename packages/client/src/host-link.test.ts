import { snapshotOf } from "@corridor/protocol/testing";
import type { AliveDriver, CommandState, DeliveredCommand } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { HostLink, type HostLinkOptions, type HostStatus } from "./host-link.ts";
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
  start: Partial<Pick<HostLinkOptions, "lastApplied" | "fresh" | "endings" | "save">> = {},
) {
  const platform = new FakePlatform();
  const commands: number[] = [];
  const stops: DeliveredCommand[] = [];
  const statuses: HostStatus[] = [];
  const heard: string[] = [];
  const delivered: DeliveredCommand[] = [];
  const alive: AliveDriver[] = [];
  const link = new HostLink({
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
      for (const seq of commands) link.ended(seq, { ...done, state: "cancelled" });
    },
    onCancel: (seq) => heard.push(`cancel ${seq}`),
    onGiveBack: () => heard.push("give back"),
    onYield: () => heard.push("yield"),
    onState: ({ seq, state }, ttl) => heard.push(`${seq} ${state} within ${ttl}`),
    onRefused: ({ seq, state }) => heard.push(`${seq} was ${state}`),
    onStored: (seq) => heard.push(`${seq} stored`),
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
  return { platform, link, commands, stops, statuses, heard, delivered, alive, welcome, reconnect };
}

describe("HostLink", () => {
  it("greets with its key and what it has done", () => {
    const { platform, link, welcome, statuses } = host({ lastApplied: 7, fresh: true });
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
    expect(link.isConnected).toBe(true);
    expect(statuses.map(({ kind }) => kind)).toEqual(["connecting", "connected"]);
  });

  it("shows the robot before it tells an ending, so that who waits reads fresh sensors", () => {
    const { platform, link, welcome } = host();
    welcome(3);
    platform.socket.receive(command(1));
    link.started(1);
    link.ended(1, done);
    expect(platform.socket.sent.slice(2).map(({ type, epoch }) => [type, epoch])).toEqual([
      ["started", 3],
      ["snapshot", 3],
      ["ended", 3],
    ]);
  });

  it("keeps endings over lost lines until they are stored", () => {
    const { platform, link, heard, welcome, reconnect } = host();
    welcome();
    platform.socket.receive(command(1));
    platform.socket.receive(command(2));
    link.started(1);
    link.ended(1, done);
    platform.socket.cut(1006);
    link.started(2);
    platform.pass(10_000);
    welcome(2);
    expect(platform.socket.sent[1]).toEqual({
      type: "resume",
      lastApplied: 2,
      fresh: false,
      page: expect.any(String),
      endings: [{ seq: 1, ...done }],
      // Who waits for that ending reads fresh sensors.
      snapshot: snapshotOf(),
    });
    expect(heard).not.toContain("1 stored");
    platform.socket.receive({ type: "stored", seq: 1 });
    expect(heard).toContain("1 stored");
    reconnect(3);
    expect(platform.socket.sent[1]).toMatchObject({ lastApplied: 2, endings: [] });
  });

  it("says on each line by the same name which page it is", () => {
    const { platform, welcome, reconnect } = host();
    welcome();
    const [, { page: name } = {}] = platform.socket.sent;
    reconnect(2);
    expect(platform.socket.sent[1]).toMatchObject({ type: "resume", page: name });
    expect(name).toBeTypeOf("string");
  });

  it("gives the robot up when another page comes: nothing begins any more, and all it had begun is told before", () => {
    const { platform, link, commands, heard, welcome, reconnect } = host();
    welcome(3);
    for (const seq of [1, 2]) platform.socket.receive(command(seq));
    link.started(1);
    heard.length = 0;
    platform.socket.receive({ type: "yield" });
    platform.socket.receive(command(3));
    expect(heard).toEqual(["give back", "yield"]);
    expect(commands).toEqual([1, 2]);
    expect(platform.socket.sent.slice(2)).toEqual([
      { type: "started", epoch: 3, seq: 1 },
      { type: "yielded", epoch: 3 },
    ]);
    // The other page went before it had the robot: this one has it again.
    reconnect(4);
    for (const seq of [2, 3]) platform.socket.receive(command(seq));
    expect(commands).toEqual([1, 2, 2, 3]);
  });

  it("never hands on again what has begun, and answers a repeated one from memory", () => {
    const { platform, link, commands, welcome, reconnect } = host();
    welcome();
    for (const seq of [1, 2, 3]) platform.socket.receive(command(seq));
    link.started(1);
    link.ended(1, done);
    link.started(2);
    reconnect(2);
    for (const seq of [1, 2, 3, 4]) platform.socket.receive(command(seq));
    expect(commands).toEqual([1, 2, 3, 3, 4]);
    expect(platform.socket.sent.slice(2)).toEqual([
      { type: "snapshot", epoch: 2, snapshot: snapshotOf() },
      { type: "ended", epoch: 2, seq: 1, ...done },
      { type: "started", epoch: 2, seq: 2 },
    ]);
  });

  it("tries again at once when asked, and hands on once what has begun all the same", () => {
    const { platform, link, commands, statuses, welcome } = host();
    welcome();
    for (const seq of [1, 2, 3]) platform.socket.receive(command(seq));
    link.started(1);
    platform.socket.cut(1006);
    link.open();
    link.open();
    expect(platform.sockets).toHaveLength(2);
    expect(statuses.map(({ kind }) => kind).slice(-2)).toEqual(["lost", "connecting"]);
    welcome(2);
    for (const seq of [2, 3, 4]) platform.socket.receive(command(seq));
    link.open();
    // Neither the pause that was cut short nor the asking of a connected link opens another line.
    platform.pass(5_000);
    expect(platform.sockets).toHaveLength(2);
    expect(link.isConnected).toBe(true);
    expect(commands).toEqual([1, 2, 3, 2, 3, 4]);
  });

  it("brings the endings that came while it was closed once it is opened again", () => {
    const { platform, link, commands, welcome } = host();
    welcome();
    for (const seq of [1, 2]) platform.socket.receive(command(seq));
    link.started(1);
    platform.socket.cut(1006);
    for (const seq of [1, 2]) link.ended(seq, { ...done, state: "cancelled" });
    link.close();
    platform.pass(60_000);
    expect(platform.sockets).toHaveLength(1);
    link.open();
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

  it("gives back what has not begun with each new line, before it says what it has done", () => {
    const { platform, link, heard, welcome, reconnect } = host();
    welcome();
    for (const seq of [1, 2, 3]) platform.socket.receive(command(seq));
    link.started(1);
    expect(heard).toEqual(["give back"]);
    reconnect(2);
    expect(heard).toEqual(["give back", "give back"]);
    expect(platform.socket.sent[1]).toMatchObject({ lastApplied: 1 });
  });

  it("says of a command that ended out of turn no more than that, and never takes it again", () => {
    const { platform, link, commands, welcome, reconnect } = host();
    welcome();
    for (const seq of [1, 2, 3]) platform.socket.receive(command(seq));
    link.started(1);
    link.ended(3, { ...done, state: "expired" });
    expect(link.lastApplied).toBe(1);
    reconnect(2);
    expect(platform.socket.sent[1]).toMatchObject({ lastApplied: 1, endings: [{ seq: 3 }] });
    platform.socket.receive({ type: "stored", seq: 3 });
    platform.socket.receive(command(2));
    platform.socket.receive(command(3));
    link.started(2);
    expect(commands).toEqual([1, 2, 3, 2]);
    expect(link.lastApplied).toBe(2);
    platform.socket.receive(command(4));
    link.started(4);
    expect(link.lastApplied).toBe(4);
  });

  it("passes on what the sender takes back, what waits, and endings that came too late", () => {
    const { platform, link, heard, welcome, reconnect } = host();
    welcome();
    platform.socket.receive(command(1));
    platform.socket.receive({ type: "cancel", seq: 1, cause: "sender" });
    platform.socket.receive({ type: "state", record: recordOf(2, "expired"), ttl: 400 });
    link.ended(1, done);
    platform.socket.receive({ type: "refused", record: recordOf(1, "cancelled") });
    expect(heard.slice(1)).toEqual(["cancel 1", "2 expired within 400", "1 was cancelled"]);
    reconnect(2);
    expect(platform.socket.sent[1]).toMatchObject({ endings: [] });
  });

  it("trusts no welcome that was held up, and asks for the relay's time until an answer is quick", () => {
    const { platform, delivered } = host();
    const asked = () => platform.socket.sent.filter(({ type }) => type === "time");
    platform.socket.open();
    platform.pass(3_000);
    platform.socket.receive({ type: "welcome", version: 1, epoch: 4, at: 0 });
    platform.socket.receive({ ...command(1), at: 0, remaining: 2_000 });
    expect(asked()).toEqual([{ type: "time", epoch: 4 }]);
    platform.pass(20);
    platform.socket.receive({ type: "time", at: 3_010 });
    platform.socket.receive({ ...command(2), at: 3_010, remaining: 2_000 });
    const scripts = { connected: 1, client: "Python", silentMs: 0, alive: [] };
    platform.socket.receive({ type: "drivers", at: 3_010, scripts: [], paused: false, ...scripts });
    expect(delivered.map(({ remaining }) => remaining)).toEqual([0, 1_990]);
    expect(asked()).toHaveLength(1);
  });

  it("takes from the time that is left what a command was held up, and from the life of a script", () => {
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
      at: 1_500,
    });
    expect(delivered.map(({ remaining }) => remaining)).toEqual([9_000, 0]);
    expect(alive).toEqual([{ driver: "Zx81qP", silentMs: 1_600, connectionMs: null }]);
  });

  it("does not hand on what it did before a reload", () => {
    const { platform, commands, welcome } = host({ lastApplied: 5, fresh: true });
    welcome();
    platform.socket.receive(command(5));
    platform.socket.receive(command(6));
    expect(commands).toEqual([6]);
  });

  it("speaks with the new epoch from the moment on that it says it is connected", () => {
    const { platform, link, statuses, welcome, reconnect } = host();
    const push = statuses.push.bind(statuses);
    statuses.push = (status) => {
      if (status.kind === "connected") link.sendSnapshot(snapshotOf());
      return push(status);
    };
    welcome(1);
    expect(platform.socket.sent.at(-1)).toMatchObject({ type: "snapshot", epoch: 1 });
    reconnect(2);
    expect(platform.socket.sent.at(-1)).toMatchObject({ type: "snapshot", epoch: 2 });
  });

  it("sends endings that came between greeting and welcome", () => {
    const { platform, link, welcome } = host();
    welcome();
    platform.socket.receive(command(1));
    platform.socket.cut(1006);
    platform.pass(10_000);
    platform.socket.open();
    link.started(1);
    link.ended(1, done);
    expect(platform.socket.sent).toHaveLength(2);
    platform.socket.receive({ type: "welcome", version: 1, epoch: 2, at: 0 });
    expect(platform.socket.sent.slice(-2)).toMatchObject([
      { type: "snapshot", epoch: 2 },
      { type: "ended", seq: 1, epoch: 2 },
    ]);
  });

  it("ends a stop by itself, after all that the robot had", () => {
    const { platform, link, stops, welcome } = host();
    welcome();
    platform.socket.receive(command(1));
    platform.socket.receive({ ...command(2), type: "stop", command: { action: "stop" } });
    expect(stops).toHaveLength(1);
    const endings = platform.socket.sent.filter(({ type }) => type === "ended");
    expect(endings.map(({ seq, state }) => [seq, state])).toEqual([
      [1, "cancelled"],
      [2, "completed"],
    ]);
    expect(link.lastApplied).toBe(2);
  });

  it.each([
    { code: 4409, kind: "replaced" },
    { code: 4404, kind: "over" },
    { code: 4410, kind: "over" },
    { code: 4401, kind: "over" },
  ])("gives up for good after close code $code", ({ code, kind }) => {
    const { platform, link, statuses, welcome } = host();
    welcome();
    platform.socket.cut(code);
    platform.pass(60_000);
    link.open();
    expect(platform.sockets).toHaveLength(1);
    expect(statuses.at(-1)).toMatchObject({ kind, reason: { code } });
  });

  it("tries again after a pause that doubles from 0.25 to 10 s and is drawn at random", () => {
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

  it("does not pause for long after a short cut, however many short pauses came before", () => {
    const { platform, statuses } = host();
    const pauses: number[] = [];
    for (const luck of [0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.999]) {
      platform.luck = luck;
      platform.socket.cut(1006);
      const status = statuses.at(-1);
      if (status?.kind !== "lost") throw new Error("the line is not lost");
      pauses.push(status.retryMs);
      platform.pass(status.retryMs);
    }
    const lostMs = pauses.slice(0, -1).reduce((sum, pause) => sum + pause, 0);
    expect(lostMs).toBeLessThan(250);
    expect(pauses.at(-1)).toBeLessThan(500);
  });

  it("takes silence and a missing welcome for a lost line", () => {
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

  it("lives on when the relay says something that it does not know", () => {
    const { platform, commands, welcome } = host();
    welcome();
    for (const text of ["", "null", "{", '{"type":"dance"}', '{"type":"command","seq":-1}']) {
      platform.socket.receiveText(text);
    }
    platform.socket.receive(command(1));
    expect(commands).toEqual([1]);
  });
});

/** A page whose device stores its world when the test says so. */
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

describe("HostLink, where the world is stored", () => {
  it("sends an ending once its world is stored, and nothing that follows before it", async () => {
    const { platform, link, sent, saved } = savingHost();
    platform.socket.receive(command(1));
    platform.socket.receive(command(2));
    link.started(1);
    link.ended(1, done);
    link.started(2);
    expect(sent()).toMatchObject([{ type: "started", seq: 1 }]);
    expect(link.journal).toEqual({ lastApplied: 2, endings: [{ seq: 1, ...done }] });
    await saved();
    expect(sent().slice(1)).toMatchObject([
      { type: "ended", seq: 1 },
      { type: "started", seq: 2 },
    ]);
  });

  it("says nothing of an ending that is not stored when it comes back on a new line", async () => {
    const { platform, link, reconnect, saved, sent } = savingHost();
    platform.socket.receive(command(1));
    link.started(1);
    link.ended(1, done);
    reconnect(2);
    expect(platform.socket.sent[1]).toMatchObject({ lastApplied: 1, endings: [] });
    expect(sent()).toEqual([]);
    await saved();
    expect(sent()).toMatchObject([{ type: "ended", seq: 1, epoch: 2 }]);
  });

  it("closes, and gives the robot up, after the endings of before", async () => {
    const { platform, link, saved, sent } = savingHost();
    platform.socket.receive(command(1));
    link.started(1);
    platform.socket.receive({ type: "yield" });
    link.ended(1, { ...done, state: "cancelled" });
    link.close();
    expect(platform.socket.isClosed).toBe(false);
    expect(link.isConnected).toBe(false);
    await saved();
    expect(sent().map(({ type }) => type)).toContain("ended");
    expect(platform.socket.isClosed).toBe(true);
  });

  it("stays open where it is opened again before those are stored", async () => {
    const { platform, link, saved, sent } = savingHost();
    platform.socket.receive(command(1));
    link.started(1);
    link.ended(1, done);
    link.close();
    link.open();
    await saved();
    expect(sent().at(-1)).toMatchObject({ type: "ended", seq: 1 });
    expect(platform.socket.isClosed).toBe(false);
    expect(link.isConnected).toBe(true);
  });

  it("is not the robot any more where another page has claimed the world", async () => {
    const { platform, link, statuses, saved, sent } = savingHost();
    platform.socket.receive(command(1));
    link.started(1);
    link.ended(1, done);
    link.worldClaimed();
    await saved();
    expect(sent()).toMatchObject([{ type: "started" }]);
    expect(platform.socket.isClosed).toBe(true);
    expect(statuses.at(-1)?.kind).toBe("replaced");
    link.open();
    expect(platform.sockets).toHaveLength(1);
  });

  it("tells what had ended in the restored world, until the relay has stored it", () => {
    const endings = [{ seq: 6, ...done }];
    const { platform, link, welcome } = host({ lastApplied: 7, fresh: true, endings });
    welcome();
    expect(platform.socket.sent[1]).toMatchObject({ lastApplied: 7, fresh: true, endings });
    platform.socket.receive({ type: "stored", seq: 6 });
    expect(link.journal).toEqual({ lastApplied: 7, endings: [] });
  });
});
