/** The connection to Redis through a network that drops all data silently. */
import { describe, expect, it, onTestFinished, vi } from "vitest";
import { hasRedis, startTestRedis } from "../../../support/relay/test-redis.ts";
import { swallowingNet } from "../../../support/relay/swallowing-net.ts";
import { asked, connectRedis } from "../../../../apps/relay/src/store/redis/connection.ts";
import { StoreUnavailableError } from "../../../../apps/relay/src/platform/errors/store-unavailable.ts";

const SOON = { timeout: 15_000, interval: 100 };

describe.skipIf(!hasRedis)("with Redis", () => {
  it("detects a dead connection within seconds, even while it writes to it, and reconnects", async () => {
    const { port } = await startTestRedis();
    const net = await swallowingNet(port);
    const redis = await connectRedis(net.url, () => undefined);
    const hearing = await connectRedis(net.url, () => undefined);
    onTestFinished(() => {
      redis.destroy();
      hearing.destroy();
    });
    const received: string[] = [];
    await hearing.subscribe("news", (text) => void received.push(text));
    net.swallow();
    const writing = setInterval(() => void redis.set("a", "b").catch(() => undefined), 50);
    onTestFinished(() => clearInterval(writing));
    await expect(asked(redis.set("last", "1"))).rejects.toBeInstanceOf(StoreUnavailableError);
    await vi.waitFor(async () => {
      await redis.publish("news", "again");
      expect(received).toContain("again");
    }, SOON);
  });

  it("logs each error of an outage once, however often it reconnects", async () => {
    const server = await startTestRedis();
    const logged: string[] = [];
    const redis = await connectRedis(server.url, (error) => logged.push(String(error)));
    onTestFinished(() => redis.destroy());
    let attempts = 0;
    redis.on("reconnecting", () => (attempts += 1));
    const outage = async (): Promise<string[]> => {
      [logged.length, attempts] = [0, 0];
      await server.stop();
      await vi.waitFor(() => expect(attempts).toBeGreaterThan(4), SOON);
      await server.restart();
      await vi.waitFor(() => expect(redis.isReady).toBe(true), SOON);
      return [...logged];
    };
    const first = await outage();
    expect(first.length).toBeGreaterThan(0);
    expect(new Set(first).size).toBe(first.length);
    expect((await outage()).length).toBeGreaterThan(0);
  });

  it("stays closed after it was closed", async () => {
    const { url } = await startTestRedis();
    vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout"] });
    onTestFinished(() => void vi.useRealTimers());
    const redis = await connectRedis(url, () => undefined);
    redis.destroy();
    await vi.advanceTimersByTimeAsync(10_000);
    expect(redis.isOpen).toBe(false);
  });
});
