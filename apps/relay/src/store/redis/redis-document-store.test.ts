import { describe, expect, it, onTestFinished } from "vitest";
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

  it("opens a link from before there were short codes, and gives the same text a code now", async () => {
    const server = await startTestRedis();
    const redis = await connectRedis(server.url, () => undefined);
    onTestFinished(() => redis.destroy());
    const store = new RedisDocumentStore(redis, new ForgottenBytes(redis));
    const document = { hash: "h", text: "{}", keyHash: "old", now: 1 };
    await store.add({ ...document, ids: ["abcdefghijkl"] });
    const again = { ...document, keyHash: "new" };
    expect(await store.add({ ...again, ids: ["BCDF"] })).toBe("BCDF");
    expect(await store.read("abcdefghijkl", 1, 1)).toBe("{}");
    expect(await store.remove("abcdefghijkl", "old")).toBe("removed");
    // Deleting the older one leaves the way from the text to its code.
    expect(await store.add({ ...again, keyHash: "newer", ids: ["GHJK"] })).toBe("BCDF");
  });
});
