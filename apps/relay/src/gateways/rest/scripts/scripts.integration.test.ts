import {
  BLOCKED_REASON,
  createdKeySchema,
  PAUSED_REASON,
  scriptListSchema,
  blockedScriptSchema,
  type Registration,
  type ScriptView,
} from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { startTestRelay, testFolder, type TestRelay } from "../../../testing/test-relay.ts";
import { TestSocket } from "../../../testing/test-socket.ts";

const LEFT = { action: "left 90" };

async function withRobot(dataDir = testFolder()) {
  const relay = await startTestRelay({ dataDir });
  const robot = await relay.register();
  return { dataDir, robot, ...helpers(relay, robot) };
}

function helpers(relay: TestRelay, robot: Registration) {
  const owner = { key: robot.ownerKey };
  const scripts = async (): Promise<ScriptView[]> =>
    scriptListSchema.parse(await (await relay.ask(robot, "/scripts", owner)).json()).scripts;
  const named = async (name: string | null) => {
    const found = (await scripts()).find((script) => script.name === name);
    if (found === undefined) throw new Error(`there is no ${name}`);
    return found;
  };
  const block = async ({ driver, name, client }: ScriptView) => {
    const body = { driver, name, client };
    const answer = await relay.ask(robot, "/blocked", { ...owner, method: "POST", body });
    expect(answer.status).toBe(201);
    return blockedScriptSchema.parse(await answer.json()).id;
  };
  const unblock = async (id: string) =>
    (await relay.ask(robot, `/blocked/${id}`, { ...owner, method: "DELETE" })).status;
  /** Sends a request as a script with a name. */
  const as = (name: string, path: string, body?: unknown) =>
    relay.ask(robot, path, {
      headers: { "Script-Name": name, "User-Agent": "Python-urllib/3.11" },
      ...(body !== undefined && { method: "POST", body }),
    });
  const socketOf = async (name: string) => {
    const socket = await TestSocket.open(relay, robot.id, { "User-Agent": "node" });
    socket.send({ type: "hello", version: 1, role: "drive", key: robot.driverKey, name });
    await socket.next("welcome");
    return socket;
  };
  return { relay, scripts, named, block, unblock, as, socketOf };
}

describe("the scripts of a robot", () => {
  it("are listed by name, with the last command of each", async () => {
    const { scripts, as, socketOf } = await withRobot();
    await as("Anna", "/commands", LEFT);
    await as("Ben%20%E2%9C%93", "/commands?after=0");
    await socketOf("Clara");
    const list = await scripts();
    expect(list).toMatchObject([
      { name: "Anna", client: "Python", connections: 0, last: { seq: 1, action: "left 90" } },
      { name: "Ben ✓", client: "Python", connections: 0, last: null },
      { name: "Clara", client: "JavaScript", connections: 1, last: null },
    ]);
    expect(new Set(list.map(({ id }) => id)).size).toBe(3);
    expect(new Set(list.map(({ driver }) => driver)).size).toBe(1);
  });

  it("are listed with the problem for which the relay last refused a command", async () => {
    const { scripts, as, socketOf, relay, robot } = await withRobot();
    await as("Anna", "/commands", { action: "move", distance: 30_000 });
    await as("Ben", "/commands", LEFT);
    const clara = await socketOf("Clara");
    clara.send({ type: "command", command: { action: "fly" } });
    await clara.next("problem");
    await relay.ask(robot, "/pause", { method: "PUT", key: robot.ownerKey });
    const dora = await socketOf("Dora");
    dora.send({ type: "command", command: LEFT });
    await dora.next("problem");
    const headers = { "Script-Name": "Emil", "Idempotency-Key": "short" };
    await relay.ask(robot, "/commands", { method: "DELETE", headers });
    const list = await scripts();
    expect(list.map(({ name, lastProblem }) => [name, lastProblem?.detail ?? null])).toEqual([
      ["Anna", expect.stringMatching(/^Invalid command\. distance: found 30000, expected /)],
      ["Ben", null],
      ["Clara", expect.stringMatching(/^Invalid message\. command\.action: found 'fly'/)],
      ["Dora", PAUSED_REASON],
      ["Emil", expect.stringMatching(/^Invalid header\. Idempotency-Key: /)],
    ]);
    const at = Date.parse(list[0]?.lastProblem?.at ?? "");
    expect(Math.abs(Date.now() - at)).toBeLessThan(60_000);
  });

  it("are also reported to the page", async () => {
    const { relay, robot, as } = await withRobot();
    const { socket: page } = await TestSocket.page(relay, robot);
    await as("Anna", "/commands", LEFT);
    await expect
      .poll(async () => (await page.next("drivers"))["scripts"], { timeout: 5_000 })
      .toMatchObject([{ name: "Anna", last: { seq: 1 } }]);
  });

  it("have names of one line and at most 40 characters", async () => {
    const { scripts, as } = await withRobot();
    await as("%00%0A%E2%80%AEevil%09name", "/commands?after=0");
    await as("x".repeat(4_000), "/commands?after=0");
    await as("100 % mine", "/commands?after=0");
    await as("%20%20", "/commands?after=0");
    const names = (await scripts()).map(({ name }) => name);
    expect(names).toEqual(["evil name", "x".repeat(40), "100 % mine", null]);
  });

  it("are no longer listed when their key is revoked, because they cannot return", async () => {
    const { relay, robot, scripts, as, socketOf } = await withRobot();
    const socket = await socketOf("Anna");
    await as("Ben", "/commands?after=0");
    const replacement = {
      method: "POST",
      key: robot.ownerKey,
      body: { kind: "drive", replace: true },
    };
    const { key } = createdKeySchema.parse(
      await (await relay.ask(robot, "/keys", replacement)).json(),
    );
    expect((await socket.closed).code).toBe(4401);
    await relay.ask(robot, "/sensors", { key, headers: { "Script-Name": "Clara" } });
    expect(await scripts()).toMatchObject([{ name: "Clara" }]);
  });

  it("are limited in memory, however many names they send", async () => {
    const { scripts, as } = await withRobot();
    for (let n = 0; n < 50; n++) await as(`script ${n}`, "/commands?after=0");
    const list = await scripts();
    expect(list).toHaveLength(16);
    expect(list.at(-1)).toMatchObject({ name: "script 49" });
  });
});

describe("a blocked script", () => {
  it("loses its connections with a reason, and is rejected until it is unblocked", async () => {
    const { relay, robot, named, block, unblock, as, socketOf } = await withRobot();
    const socket = await socketOf("Anna");
    const waiting = as("Anna", "/events?since=00000000-0&wait=25");
    const opened = await relay.ask(robot, "/long-poll", {
      method: "POST",
      body: { type: "hello", version: 1, role: "drive", key: robot.driverKey, name: "Anna" },
    });
    const { key } = (await opened.json()) as { key: string };
    await waiting;
    const poll = as("Anna", "/sensors?wait=25");
    await as("Anna", "/commands?after=0");
    const anna = await block(await named("Anna"));

    const { code, reason } = await socket.closed;
    expect([code, reason]).toEqual([4403, expect.stringContaining("blocked this script")]);
    expect((await poll).status).toBe(403);
    const fetched = await relay.ask(robot, "/long-poll/messages?after=1", { key });
    expect(await fetched.json()).toMatchObject({ closed: { code: 4403 } });
    const refused = await as("Anna", "/commands", LEFT);
    expect(refused.status).toBe(403);
    expect(await refused.json()).toMatchObject({
      type: "/problems/blocked",
      detail: expect.stringContaining("press 'Unblock'"),
    });
    const again = await TestSocket.open(relay, robot.id);
    again.send({ type: "hello", version: 1, role: "drive", key: robot.driverKey, name: "Anna" });
    expect((await again.closed).code).toBe(4403);
    expect(await named("Anna")).toMatchObject({ isBlocked: true, connections: 0 });

    expect(await unblock(anna)).toBe(204);
    expect(await named("Anna")).toMatchObject({ isBlocked: false, connections: 0 });
    expect((await as("Anna", "/commands", LEFT)).status).toBe(202);
    expect(await unblock(anna)).toBe(404);
  });

  it("does not affect others with the same key, and its open commands end", async () => {
    const { relay, robot, named, block, as, socketOf } = await withRobot();
    const { socket: page, epoch } = await TestSocket.page(relay, robot);
    const ben = await socketOf("Ben");
    for (let count = 0; count < 10; count++) await as("Anna", "/commands", LEFT);
    ben.send({ type: "command", command: LEFT });
    expect(await ben.next("ack")).toMatchObject({ record: { seq: 11 } });
    page.send({ type: "started", epoch, seq: 1 });
    await block(await named("Anna"));
    // The robot ends the commands that it has received.
    expect(await page.next("cancel")).toMatchObject({ seq: 1, cause: "blocked" });
    await expect
      .poll(async () => (await (await as("Ben", "/commands?after=9")).json()) as unknown)
      .toMatchObject({
        commands: [{ seq: 10, state: "cancelled", reason: BLOCKED_REASON }, { seq: 11 }],
      });
    ben.send({ type: "command", command: LEFT });
    expect(await ben.next("ack")).toMatchObject({ record: { seq: 12 } });
  });

  it("stays blocked after a restart of the relay, and is removed with its key", async () => {
    const before = await withRobot();
    const { robot } = before;
    await before.as("Anna", "/commands?after=0");
    await before.block(await before.named("Anna"));
    await before.relay.close();
    const after = helpers(await startTestRelay({ dataDir: before.dataDir }), robot);
    expect((await after.as("Anna", "/commands?after=0")).status).toBe(403);
    const wanted = { kind: "drive", replace: true };
    await after.relay.ask(robot, "/keys", { method: "POST", key: robot.ownerKey, body: wanted });
    expect(await after.scripts()).toEqual([]);
    expect((await after.as("Anna", "/commands?after=0")).status).toBe(401);
  });

  it("is one of at most 16, and must have a key of this robot", async () => {
    const { relay, robot, as, named, block } = await withRobot();
    for (let n = 0; n < 16; n++) {
      await as(`${n}`, "/commands?after=0");
      await block(await named(`${n}`));
    }
    await as("one more", "/commands?after=0");
    const { driver, client } = await named("one more");
    const post = (body: unknown) =>
      relay.ask(robot, "/blocked", { method: "POST", key: robot.ownerKey, body });
    const full = await post({ driver, client, name: "one more" });
    expect([full.status, await full.json()]).toMatchObject([
      409,
      { type: "/problems/too-many-blocked" },
    ]);
    const unknown = await post({ driver: "______", client, name: "Anna" });
    expect([unknown.status, await unknown.json()]).toMatchObject([
      409,
      { type: "/problems/unknown-driver" },
    ]);
    expect((await post({ driver, client })).status).toBe(400);
    expect((await post({ driver, client, name: "" })).status).toBe(400);
  });
});

describe("paused remote driving", () => {
  const pause = async ({ relay, robot }: Awaited<ReturnType<typeof withRobot>>, method = "PUT") =>
    (await relay.ask(robot, "/pause", { method, key: robot.ownerKey })).status;

  it("rejects commands with an explanation, accepts stops, and lets scripts read", async () => {
    const world = await withRobot();
    const { relay, robot, as, socketOf } = world;
    const { socket: page } = await TestSocket.page(relay, robot);
    const script = await socketOf("Anna");
    expect(await pause(world)).toBe(204);
    await expect.poll(async () => (await page.next("drivers"))["paused"]).toBe(true);
    const refused = await as("Ben", "/commands", LEFT);
    expect([refused.status, await refused.json()]).toMatchObject([
      409,
      { type: "/problems/driving-paused", detail: PAUSED_REASON },
    ]);
    script.send({ type: "command", key: "a-key-0001", command: LEFT });
    expect(await script.next("problem")).toMatchObject({
      key: "a-key-0001",
      problem: { type: "/problems/driving-paused" },
    });
    expect((await relay.ask(robot, "/commands", { method: "DELETE" })).status).toBe(202);
    expect(await page.next("stop")).toMatchObject({ seq: 1 });
    expect((await as("Ben", "/commands?after=0")).status).toBe(200);
    expect(await pause(world, "DELETE")).toBe(204);
    script.send({ type: "command", key: "a-key-0001", command: LEFT });
    expect(await script.next("ack")).toMatchObject({ record: { seq: 2 } });
  });

  it("ends waiting commands immediately and asks the robot to end the rest", async () => {
    const world = await withRobot();
    const { relay, robot, as } = world;
    const { socket: page } = await TestSocket.page(relay, robot);
    for (let n = 0; n < 9; n++) await as("Anna", "/commands", LEFT);
    await pause(world);
    for (let seq = 1; seq <= 8; seq++) {
      expect(await page.next("cancel")).toEqual({ type: "cancel", seq, cause: "paused" });
    }
    expect(await (await relay.ask(robot, "/commands/9?wait=5")).json()).toMatchObject({
      state: "cancelled",
      reason: PAUSED_REASON,
    });
  });

  it("persists across a restart of the relay, and pausing again changes nothing", async () => {
    const world = await withRobot();
    expect([await pause(world), await pause(world)]).toEqual([204, 204]);
    await world.relay.close();
    const relay = await startTestRelay({ dataDir: world.dataDir });
    const after = helpers(relay, world.robot);
    expect((await after.as("Anna", "/commands", LEFT)).status).toBe(409);
    const { socket: page } = await TestSocket.page(relay, world.robot);
    expect(await page.next("drivers")).toMatchObject({ paused: true });
    const again = { ...world, relay };
    expect([await pause(again, "DELETE"), await pause(again, "DELETE")]).toEqual([204, 204]);
    expect((await after.as("Anna", "/commands", LEFT)).status).toBe(202);
  });
});

describe("resets by scripts", () => {
  const RESET = { action: "reset" };
  const permit = async ({ relay, robot }: Awaited<ReturnType<typeof withRobot>>, method: string) =>
    (await relay.ask(robot, "/script-reset", { method, key: robot.ownerKey })).status;

  it("are accepted at most once a second, and the key of a rejected one stays free", async () => {
    const { as } = await withRobot();
    const first = await as("Anna", "/commands", RESET);
    expect([first.status, await first.json()]).toMatchObject([202, { action: "reset" }]);
    const second = await as("Ben", "/commands", RESET);
    expect(second.headers.get("Retry-After")).toBe("1");
    expect([second.status, await second.json()]).toMatchObject([
      429,
      { type: "/problems/too-fast" },
    ]);
    const later = async (): Promise<number> => (await as("Ben", "/commands", RESET)).status;
    await expect.poll(later, { timeout: 5_000 }).toBe(202);
  });

  it("are rejected while the owner forbids them, which the page and the list of scripts show", async () => {
    const world = await withRobot();
    const { relay, robot, as } = world;
    const { socket: page } = await TestSocket.page(relay, robot);
    expect([await permit(world, "DELETE"), await permit(world, "DELETE")]).toEqual([204, 204]);
    await expect.poll(async () => (await page.next("drivers"))["mayReset"]).toBe(false);
    const refused = await as("Anna", "/commands", RESET);
    expect([refused.status, await refused.json()]).toMatchObject([
      403,
      { type: "/problems/reset-disabled" },
    ]);
    expect((await as("Anna", "/commands", LEFT)).status).toBe(202);
    const list = await relay.ask(robot, "/scripts", { key: robot.ownerKey });
    expect(await list.json()).toMatchObject({ paused: false, mayReset: false });
    expect(await permit(world, "PUT")).toBe(204);
    expect((await as("Anna", "/commands", RESET)).status).toBe(202);
  });
});
