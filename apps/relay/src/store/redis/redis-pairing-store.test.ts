import { describe, onTestFinished } from "vitest";
import { hasRedis, startTestRedis } from "../../platform/testing/test-redis.ts";
import { pairingStoreCases } from "../cases/pairing-store.cases.ts";
import { connectRedis } from "./connection.ts";
import { DeletedBytes } from "./deleted-bytes.ts";
import { RedisPairingStore } from "./redis-pairing-store.ts";
import { RedisRobotStore } from "./redis-robot-store.ts";

describe.skipIf(!hasRedis)("with Redis", () => {
  pairingStoreCases("RedisPairingStore", async () => {
    // Not "everysec", which can delay even writes by one or two seconds on a busy disk.
    const server = await startTestRedis(["--appendfsync", "always"]);
    const open = async () => {
      const redis = await connectRedis(server.url, () => undefined);
      onTestFinished(() => redis.destroy());
      const deletedBytes = new DeletedBytes(redis);
      return {
        store: new RedisPairingStore(redis, deletedBytes),
        robots: new RedisRobotStore(redis, deletedBytes, "relay-a"),
      };
    };
    return {
      ...(await open()),
      reopen: async () => (await open()).store,
      holds: async (text) => server.holds(text),
    };
  });
});
