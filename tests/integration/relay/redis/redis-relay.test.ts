import { problemSchema } from "@corridor/protocol";
import { describe, expect, it, onTestFinished, vi } from "vitest";
import { systemClock } from "../../../../apps/relay/src/platform/time/clock.ts";
import { connectRedis } from "../../../../apps/relay/src/store/redis/connection.ts";
import { launchRelayProcess } from "../../../support/test-relay-process.ts";
import { hasRedis, startTestRedis } from "../../../support/relay/test-redis.ts";
import { startTestRelay } from "../../../../apps/relay/src/testing/test-relay.ts";
import { TestSocket } from "../../../../apps/relay/src/testing/test-socket.ts";

const SOON = { timeout: 10_000, interval: 100 };
const left90 = { method: "POST", body: { action: "left 90" } };

describe.skipIf(!hasRedis)("a relay with Redis", () => {
  it("restores everything after a restart", async () => {
    const { url } = await startTestRedis();
    const first = await startTestRelay({ config: { storeUrl: url } });
    const robot = await first.register();
    expect((await first.ask(robot, "/commands", left90)).status).toBe(202);
    await first.close();
    const second = await startTestRelay({ config: { storeUrl: url } });
    const log = await second.ask(robot, "/commands");
    expect(await log.json()).toMatchObject({ commands: [{ seq: 1, state: "accepted" }] });
    const { socket: page } = await TestSocket.page(second, robot);
    expect(await page.next("command")).toMatchObject({ seq: 1 });
    const gone = await second.ask(robot, "", { method: "DELETE", key: robot.ownerKey });
    expect(gone.status).toBe(204);
    expect((await second.ask(robot, "/commands")).status).toBe(404);
  });

  it.each([60_000, -60_000])(
    "delivers commands in time if the clock of the storing relay is %d ms off",
    async (off) => {
      const { url } = await startTestRedis();
      const wrong = {
        now: () => systemClock.now() + off,
        after: systemClock.after.bind(systemClock),
      };
      const scripts = await startTestRelay({ config: { storeUrl: url }, clock: wrong });
      const pages = await startTestRelay({ config: { storeUrl: url } });
      const robot = await scripts.register();
      const { socket: page } = await TestSocket.page(pages, robot);
      await scripts.ask(robot, "/commands", {
        method: "POST",
        body: { action: "left 90", ttl: 5_000 },
      });
      const { remaining } = await page.next("command");
      expect(remaining).toBeGreaterThan(0);
      expect(remaining).toBeLessThanOrEqual(5_000);
      await scripts.ask(robot, "/commands", {
        method: "POST",
        body: { action: "right 90", ttl: 300, replace: true },
      });
      expect(await page.next("command")).toMatchObject({ ttl: 300, replace: true });
    },
  );

  it("reports that its store is unavailable, and recovers when the store is back", async () => {
    const redis = await startTestRedis();
    const relay = await startTestRelay({ config: { storeUrl: redis.url } });
    const robot = await relay.register();
    await redis.stop();
    const answer = await relay.ask(robot, "/commands", left90);
    expect(answer.status).toBe(503);
    expect(answer.headers.get("retry-after")).toBe("2");
    const problem = problemSchema.parse(await answer.json());
    expect(problem.type).toBe("/problems/no-store");
    await vi.waitFor(
      async () => expect((await fetch(`${relay.origin}/readyz`)).status).toBe(503),
      SOON,
    );
    await redis.restart();
    await vi.waitFor(
      async () => expect((await relay.ask(robot, "/commands", left90)).status).toBe(202),
      SOON,
    );
  });

  it("assigns a number above all that the page has seen after Redis lost its latest writes", async () => {
    const redis = await startTestRedis();
    const relay = await startTestRelay({ config: { storeUrl: redis.url } });
    const robot = await relay.register();
    const { socket: page } = await TestSocket.page(relay, robot, { lastApplied: 41 });
    await relay.ask(robot, "/commands", left90);
    expect(await page.next("command")).toMatchObject({ seq: 42 });
  });

  it("answers 507 while the memory of Redis is full, and still lets owners delete", async () => {
    const { url } = await startTestRedis();
    const redis = await connectRedis(url, () => undefined);
    onTestFinished(() => redis.destroy());
    const relay = await startTestRelay({ config: { storeUrl: url } });
    const robot = await relay.register();
    // Less than an empty Redis uses.
    await redis.configSet("maxmemory", "100kb");
    expect((await relay.ask(robot, "/commands", left90)).status).toBe(507);
    const ready = await fetch(`${relay.origin}/readyz`);
    expect(await ready.json()).toEqual({ status: "degraded" });
    const gone = await relay.ask(robot, "", { method: "DELETE", key: robot.ownerKey });
    expect(gone.status).toBe(204);
    await redis.configSet("maxmemory", "0");
    await relay.register();
  });

  it("does not start with a Redis that could lose acknowledged commands, and explains the fix", async () => {
    const { url } = await startTestRedis(["--appendonly", "no"]);
    const relay = launchRelayProcess({ environment: { STORE_URL: url } });
    expect(await relay.exitCode()).toBe(1);
    expect(relay.log).toMatch(/cannot start: .*--appendonly yes/);
    expect(relay.log).not.toMatch(/\n\s+at /);
  });
});
