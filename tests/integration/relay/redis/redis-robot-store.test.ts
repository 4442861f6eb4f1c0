import { describe, expect, it, onTestFinished } from "vitest";
import { hasRedis, startTestRedis } from "../../../support/relay/test-redis.ts";
import { storeCases } from "../../../../apps/relay/src/store/cases/store.cases.ts";
import { connectRedis } from "../../../../apps/relay/src/store/redis/connection.ts";
import { requireDurable } from "../../../../apps/relay/src/store/redis/durability.ts";
import { DeletedBytes } from "../../../../apps/relay/src/store/redis/deleted-bytes.ts";
import { RedisRobotStore } from "../../../../apps/relay/src/store/redis/redis-robot-store.ts";

async function openAt(url: string) {
  const redis = await connectRedis(url, () => undefined);
  onTestFinished(() => redis.destroy());
  return { redis, store: new RedisRobotStore(redis, new DeletedBytes(redis), "relay-a") };
}

describe.skipIf(!hasRedis)("with Redis", () => {
  storeCases("RedisRobotStore", async () => {
    // Not "everysec", which can delay even writes by one or two seconds on a busy disk.
    const server = await startTestRedis(["--appendfsync", "always"]);
    return {
      store: (await openAt(server.url)).store,
      reopen: async () => (await openAt(server.url)).store,
      holds: async (text) => server.holds(text),
    };
  });

  it("is rejected at startup if it could lose acknowledged commands", async () => {
    const refused = async (settings: string[]) => {
      const { redis } = await openAt((await startTestRedis(settings)).url);
      return requireDurable(redis).then(
        () => "",
        (error: unknown) => String(error),
      );
    };
    expect(await refused(["--appendonly", "no"])).toMatch(/--appendonly yes/);
    expect(await refused(["--appendfsync", "no"])).toMatch(/appendfsync everysec/);
    const evicting = ["--maxmemory", "100mb", "--maxmemory-policy", "allkeys-lru"];
    expect(await refused(evicting)).toMatch(/noeviction/);
    expect(await refused(["--appendfsync", "always"])).toBe("");
  });

  it("names the address in the error if the server does not respond", async () => {
    await expect(connectRedis("redis://127.0.0.1:1", () => undefined)).rejects.toThrow(
      /Cannot connect to Redis at .* correct STORE_URL/,
    );
  });
});
