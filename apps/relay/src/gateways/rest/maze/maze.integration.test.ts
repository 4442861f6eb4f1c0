import { createdKeySchema, problemSchema, type Registration } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { limits } from "../../../platform/limits/limits.ts";
import { FakeClock } from "../../../platform/testing/fake-clock.ts";
import { maze, program } from "../../../platform/testing/sample-documents.ts";
import { startTestRelay, testFolder, type TestRelay } from "../../../testing/test-relay.ts";
import { TestSocket } from "../../../testing/test-socket.ts";

const OTHER = { ...maze, name: "Another one" };

async function withRobot() {
  const relay = await startTestRelay();
  const robot = await relay.register();
  return { relay, robot };
}

function publish(relay: TestRelay, robot: Registration, body: unknown): Promise<Response> {
  return relay.ask(robot, "/maze", { method: "PUT", key: robot.ownerKey, body });
}

async function watchKey(relay: TestRelay, robot: Registration): Promise<string> {
  const request = { method: "POST", key: robot.ownerKey, body: { kind: "watch" } };
  return createdKeySchema.parse(await (await relay.ask(robot, "/keys", request)).json()).key;
}

async function problemOf(answer: Response): Promise<string> {
  return problemSchema.parse(await answer.json()).type;
}

describe("the maze of a robot", () => {
  it("is returned to scripts and watchers as published, with an ETag", async () => {
    const { relay, robot } = await withRobot();
    const given = await publish(relay, robot, maze);
    expect(given.status).toBe(204);
    const tag = given.headers.get("etag") ?? "";
    expect(tag).toMatch(/^"[A-Za-z0-9_-]{22}"$/);
    for (const key of [robot.driverKey, robot.ownerKey, await watchKey(relay, robot)]) {
      const answer = await relay.ask(robot, "/maze", { key });
      expect(answer.status).toBe(200);
      expect(answer.headers.get("content-type")).toMatch(/^application\/json/);
      expect(answer.headers.get("etag")).toBe(tag);
      expect(await answer.json()).toEqual(maze);
    }
    const weak = { headers: { "If-None-Match": `"other", W/${tag}` } };
    const known = await relay.ask(robot, "/maze", weak);
    expect([known.status, await known.text()]).toEqual([304, ""]);
    await publish(relay, robot, OTHER);
    expect((await relay.ask(robot, "/maze", weak)).status).toBe(200);
  });

  it("does not exist until the page publishes it", async () => {
    const { relay, robot } = await withRobot();
    const answer = await relay.ask(robot, "/maze");
    expect([answer.status, await problemOf(answer)]).toEqual([404, "/problems/no-maze"]);
  });

  it("is part of the stored state of a robot, survives a restart and is deleted with the robot", async () => {
    const dataDir = testFolder();
    const first = await startTestRelay({ dataDir });
    const robot = await first.register();
    const own = { key: robot.ownerKey };
    expect(await (await first.ask(robot, "", own)).json()).toMatchObject({ maze: null });
    const tag = (await publish(first, robot, maze)).headers.get("etag") ?? "";
    await first.close();
    const relay = await startTestRelay({ dataDir });
    expect(await (await relay.ask(robot, "", own)).json()).toMatchObject({
      maze: tag.slice(1, -1),
    });
    expect(await (await relay.ask(robot, "/maze")).json()).toEqual(maze);
    await relay.ask(robot, "", { method: "DELETE", ...own });
    const gone = await relay.ask(robot, "/maze");
    expect(await problemOf(gone)).toBe("/problems/no-robot");
  });

  it("publishes changes to all readers, but not a republished equal maze", async () => {
    const { relay, robot } = await withRobot();
    const script = await TestSocket.driver(relay, robot);
    const watcher = await TestSocket.open(relay, robot.id);
    const key = await watchKey(relay, robot);
    watcher.send({ type: "hello", version: 1, role: "watch", key });
    await watcher.next("welcome");
    const stop = new AbortController();
    const events = await relay.ask(robot, "/events", { key, signal: stop.signal });
    await publish(relay, robot, maze);
    await publish(relay, robot, maze);
    const tag = (await publish(relay, robot, OTHER)).headers.get("etag") ?? "";
    for (const reader of [script, watcher]) {
      const versions = [await reader.next("maze"), await reader.next("maze")];
      expect(versions[0]).not.toEqual(versions[1]);
      expect(versions[1]).toEqual({ type: "maze", version: tag.slice(1, -1) });
    }
    const text = new TextDecoder();
    let received = "";
    for await (const part of events.body ?? []) {
      received += text.decode(part, { stream: true });
      if (received.includes(`event: maze\ndata: {"version":"${tag.slice(1, -1)}"}\n\n`)) break;
    }
    expect(received.match(/event: maze/g)).toHaveLength(2);
    stop.abort();
  });

  it.each([
    { name: "a program", body: program, status: 400 },
    { name: "a maze without a start", body: { ...maze, start: undefined }, status: 400 },
    { name: "a maze with an unknown field", body: { ...maze, extra: 1 }, status: 400 },
    { name: "a maze with an unknown character", body: { ...maze, blocks: ["#?#"] }, status: 400 },
    { name: "an empty body", body: "", status: 400 },
    { name: "more than 64 KiB", body: { ...maze, name: "x".repeat(66_000) }, status: 413 },
  ])(
    "is rejected with an explanation if it is $name, and the previous maze remains",
    async ({ body, status }) => {
      const { relay, robot } = await withRobot();
      await publish(relay, robot, maze);
      const answer = await publish(relay, robot, body);
      expect(answer.status).toBe(status);
      expect(problemSchema.parse(await answer.json()).detail).toMatch(/\w+ \w+/);
      expect(await (await relay.ask(robot, "/maze")).json()).toEqual(maze);
    },
  );

  it("is rate limited, and accepted again later", async () => {
    const clock = new FakeClock();
    const relay = await startTestRelay({ clock });
    const robot = await relay.register();
    const statuses: number[] = [];
    for (let n = 0; n <= limits.mazeRate.burst; n++) {
      statuses.push((await publish(relay, robot, { ...maze, name: `${n}` })).status);
    }
    expect(statuses.filter((status) => status === 204)).toHaveLength(limits.mazeRate.burst);
    const refused = await publish(relay, robot, maze);
    expect(refused.status).toBe(429);
    expect(Number(refused.headers.get("retry-after"))).toBeGreaterThan(0);
    await clock.pass(1_000 / limits.mazeRate.perSecond);
    expect((await publish(relay, robot, maze)).status).toBe(204);
  });

  it("cannot be published by scripts and watchers, whose body is not read", async () => {
    const { relay, robot } = await withRobot();
    for (const key of [robot.driverKey, await watchKey(relay, robot)]) {
      const body = " ".repeat(70_000);
      const answer = await relay.ask(robot, "/maze", { method: "PUT", key, body });
      expect(answer.status).toBe(403);
    }
    expect((await relay.ask(robot, "/maze")).status).toBe(404);
  });

  it("can be read from every site, including its ETag", async () => {
    const { relay, robot } = await withRobot();
    const asked = await relay.ask(robot, "/maze", { method: "OPTIONS" });
    expect(asked.headers.get("access-control-allow-headers")).toContain("If-None-Match");
    expect(asked.headers.get("access-control-expose-headers")).toContain("ETag");
  });
});
