/**
 * Erases deleted data from the files of Redis. The append-only file records a deletion as one more
 * entry. Only a rewrite of the file removes the deleted data.
 */
import { setTimeout as pause } from "node:timers/promises";
import { ErrorReply } from "@redis/client";
import { asked, type Redis } from "./connection.ts";
import { valueIn } from "./durability.ts";

const POLL_MS = 20;

export class DeletedBytes {
  readonly #redis: Redis;
  /** the rewrite that has not started yet; calls before its start share it */
  #next: Promise<void> | null = null;
  #newest: Promise<void> = Promise.resolve();

  constructor(redis: Redis) {
    this.#redis = redis;
  }

  /** @returns once the files contain no data that was deleted before this call */
  sweep(): Promise<void> {
    this.#next ??= this.#afterNewest();
    return this.#next;
  }

  async #afterNewest(): Promise<void> {
    const before = this.#newest;
    const next = before.catch(() => undefined).then(() => this.#rewrite());
    this.#newest = next;
    return next;
  }

  async #rewrite(): Promise<void> {
    for (;;) {
      // A rewrite by another relay may have started before the deletion.
      await this.#untilIdle();
      this.#next = null;
      try {
        await asked(this.#redis.bgRewriteAof());
        break;
      } catch (error) {
        const isBegun = error instanceof ErrorReply && /in progress/.test(error.message);
        if (!isBegun) throw error;
      }
    }
    await this.#untilIdle();
  }

  async #untilIdle(): Promise<void> {
    for (let ms = POLL_MS; ; ms = Math.min(1_000, ms * 1.5)) {
      const info = await asked(this.#redis.info("persistence"));
      const fields = ["aof_rewrite_in_progress", "aof_rewrite_scheduled"];
      if (fields.every((field) => valueIn(info, field) !== "1")) return;
      await pause(ms);
    }
  }
}
