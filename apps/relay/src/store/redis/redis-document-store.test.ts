import { describe, onTestFinished } from "vitest";
import { hasRedis, startTestRedis } from "../../testing/test-redis.ts";
import { documentStoreCases } from "../testing/document-store.cases.ts";
import { connectRedis } from "./connection.ts";
import { ForgottenBytes } from "./forgotten-bytes.ts";
import { RedisDocumentStore } from "./redis-document-store.ts";

describe.skipIf(!hasRedis)("with Redis", () => {
  documentStoreCases("RedisDocumentStore", async () => {
    // At once: on a busy disk, "everysec" lets even the writing wait for a second or two.
    const server = await startTestRedis(["--appendfsync", "always"]);
    const open = async () => {
      const redis = await connectRedis(server.url, () => undefined);
      onTestFinished(() => redis.destroy());
      return new RedisDocumentStore(redis, new ForgottenBytes(redis));
    };
    return { store: await open(), reopen: open, holds: async (text) => server.holds(text) };
  });
});
