import { describe, expect, it } from "vitest";
import type { Redis } from "./connection.ts";
import { DeletedBytes } from "./deleted-bytes.ts";

/** Redis whose rewrites end at once. */
function fakeRedis() {
  const state = { isConnected: true, status: "ok", rewrites: 0 };
  const redis = {
    info: async () => {
      await Promise.resolve();
      if (!state.isConnected) throw new Error("The client is closed");
      return [
        "aof_rewrite_in_progress:0",
        "aof_rewrite_scheduled:0",
        `aof_last_bgrewrite_status:${state.status}`,
      ].join("\r\n");
    },
    bgRewriteAof: async () => {
      await Promise.resolve();
      state.rewrites += 1;
    },
  } as unknown as Redis;
  const bytes = new DeletedBytes(redis);
  return { state, bytes };
}

describe("erasing deleted data from the files of Redis", () => {
  it("rewrites nothing without a deletion", async () => {
    const { state, bytes } = fakeRedis();
    await bytes.sweep();
    bytes.deleted();
    await bytes.sweep();
    await bytes.sweep();
    expect(state.rewrites).toBe(1);
  });

  it("shares one rewrite among the deletions before its start", async () => {
    const { state, bytes } = fakeRedis();
    bytes.deleted();
    const first = bytes.sweep();
    bytes.deleted();
    await Promise.all([first, bytes.sweep()]);
    expect(state.rewrites).toBe(1);
  });

  it("succeeds again after Redis was away for a moment", async () => {
    const { state, bytes } = fakeRedis();
    bytes.deleted();
    state.isConnected = false;
    await expect(bytes.sweep()).rejects.toThrow("the store is unavailable");
    state.isConnected = true;
    await bytes.sweep();
    expect(state.rewrites).toBe(1);
  });

  it("fails if Redis could not rewrite its file, and tries again although nothing more is deleted", async () => {
    const { state, bytes } = fakeRedis();
    bytes.deleted();
    state.status = "err";
    await expect(bytes.sweep()).rejects.toThrow("the store is unavailable");
    state.status = "ok";
    await bytes.sweep();
    expect(state.rewrites).toBe(2);
  });
});
