import { describe, expect, it, onTestFinished } from "vitest";
import { hasRedis, startTestRedis } from "../../../support/relay/test-redis.ts";
import { documentStoreCases } from "../../../../apps/relay/src/store/cases/document-store.cases.ts";
import { connectRedis } from "../../../../apps/relay/src/store/redis/connection.ts";
import { DeletedBytes } from "../../../../apps/relay/src/store/redis/deleted-bytes.ts";
import { RedisDocumentStore } from "../../../../apps/relay/src/store/redis/redis-document-store.ts";

describe.skipIf(!hasRedis)("with Redis", () => {
  documentStoreCases("RedisDocumentStore", async () => {
    // Not "everysec", which can delay even writes by one or two seconds on a busy disk.
    const server = await startTestRedis(["--appendfsync", "always"]);
    const open = async () => {
      const redis = await connectRedis(server.url, () => undefined);
      onTestFinished(() => redis.destroy());
      return new RedisDocumentStore(redis, new DeletedBytes(redis));
    };
    return { store: await open(), reopen: open, holds: async (text) => server.holds(text) };
  });

  it("never assigns one code to two texts, even if two relays request the same codes concurrently", async () => {
    const server = await startTestRedis();
    const relays = await Promise.all(
      [0, 1].map(async () => {
        const redis = await connectRedis(server.url, () => undefined);
        onTestFinished(() => redis.destroy());
        return new RedisDocumentStore(redis, new DeletedBytes(redis));
      }),
    );
    // Both relays try the same codes in the same order, for different texts.
    const wanted = Array.from({ length: 120 }, (_, at) => `C${String(at).padStart(3, "0")}`);
    const given = await Promise.all(
      Array.from({ length: 50 }, (_, at) =>
        relays.map(async (relay, which) => {
          const text = `{"relay":${which},"text":${at}}`;
          const document = { hash: text, text, keyHash: "key", now: 1, ids: wanted };
          return { text, id: await relay.add(document) };
        }),
      ).flat(),
    );
    expect(new Set(given.map(({ id }) => id)).size).toBe(given.length);
    const [first, second] = relays;
    for (const { text, id } of given) {
      expect(await first?.read(id, 1, 1)).toBe(text);
      expect(await second?.read(id, 1, 1)).toBe(text);
    }
  });
});
