/** Documents behind short links in Redis or Valkey. */
import { z } from "zod";
import { isDiskFull } from "../../platform/errors/disk-full.ts";
import type { DocumentStore, NewDocument, RemoveResult } from "../document-store.ts";
import { asked, type Redis } from "./connection.ts";
import type { DeletedBytes } from "./deleted-bytes.ts";
import { Script } from "./script.ts";

const USES = "corridor:documents";
/** Documents to delete per step, because each step blocks Redis. */
const MOST_AT_ONCE = 500;

const removeResult = z.enum(["removed", "no-document", "wrong-key"]);

export class RedisDocumentStore implements DocumentStore {
  readonly #redis: Redis;
  readonly #script: Script;
  readonly #deletedBytes: DeletedBytes;

  /** @param redis closed by the caller */
  constructor(redis: Redis, deletedBytes: DeletedBytes) {
    this.#redis = redis;
    this.#script = new Script(redis, ["documents.lua"]);
    this.#deletedBytes = deletedBytes;
  }

  async add(document: NewDocument): Promise<string> {
    return z.string().parse(await this.#script.run("add", [USES], document));
  }

  async read(id: string, now: number, noteMs: number): Promise<string | null> {
    const text = await asked(this.#redis.hGet(`corridor:document:${id}`, "text"));
    if (text === null) return null;
    try {
      await this.#script.run("use", [USES], { id, now, before: now - noteMs });
    } catch (error) {
      // Reading must work if the store is full. The next read records its use instead.
      if (!isDiskFull(error)) throw error;
    }
    return text;
  }

  async remove(id: string, keyHash: string): Promise<RemoveResult> {
    const result = removeResult.parse(await this.#script.run("remove", [USES], { id, keyHash }));
    if (result === "removed") this.#deletedBytes.deleted();
    await this.#deletedBytes.sweep();
    return result;
  }

  async removeUnused(before: number): Promise<number> {
    let total = 0;
    for (let count = MOST_AT_ONCE; count === MOST_AT_ONCE; total += count) {
      const values = { before, most: MOST_AT_ONCE };
      count = z.int().parse(await this.#script.run("removeUnused", [USES], values));
    }
    if (total > 0) this.#deletedBytes.deleted();
    await this.#deletedBytes.sweep();
    return total;
  }

  async close(): Promise<void> {
    // Other stores share the connection.
  }
}
