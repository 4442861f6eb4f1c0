import { describe, onTestFinished } from "vitest";
import { hasRedis, startTestRedis } from "../../../support/relay/test-redis.ts";
import { pairingStoreCases } from "../../../../apps/relay/src/store/cases/pairing-store.cases.ts";
import { connectRedis } from "../../../../apps/relay/src/store/redis/connection.ts";
import { DeletedBytes } from "../../../../apps/relay/src/store/redis/deleted-bytes.ts";
import { RedisPairingStore } from "../../../../apps/relay/src/store/redis/redis-pairing-store.ts";
import { RedisRobotStore } from "../../../../apps/relay/src/store/redis/redis-robot-store.ts";

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
