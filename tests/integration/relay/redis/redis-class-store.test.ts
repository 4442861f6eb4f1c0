import { describe, onTestFinished } from "vitest";
import { hasRedis, startTestRedis } from "../../../support/relay/test-redis.ts";
import { classStoreCases } from "../../../../apps/relay/src/store/cases/class-store.cases.ts";
import { connectRedis } from "../../../../apps/relay/src/store/redis/connection.ts";
import { DeletedBytes } from "../../../../apps/relay/src/store/redis/deleted-bytes.ts";
import { RedisClassStore } from "../../../../apps/relay/src/store/redis/redis-class-store.ts";

describe.skipIf(!hasRedis)("with Redis", () => {
  classStoreCases("RedisClassStore", async () => {
    // Not "everysec", which can delay even writes by one or two seconds on a busy disk.
    const server = await startTestRedis(["--appendfsync", "always"]);
    const open = async () => {
      const redis = await connectRedis(server.url, () => undefined);
      onTestFinished(() => redis.destroy());
      return new RedisClassStore(redis, new DeletedBytes(redis));
    };
    return { store: await open(), reopen: open, holds: async (text) => server.holds(text) };
  });
});
