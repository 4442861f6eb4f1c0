/**
 * Erases deleted data from the files of Redis. The append-only file records a deletion as one more
 * entry. Only a rewrite of the file removes the deleted data.
 */
import { setTimeout as pause } from "node:timers/promises";
import { ErrorReply } from "@redis/client";
import { StoreUnavailableError } from "../../platform/errors/store-unavailable.ts";
import { asked, type Redis } from "./connection.ts";
import { valueIn } from "./durability.ts";

const POLL_MS = 20;

export class DeletedBytes {
  readonly #redis: Redis;
  /** the rewrite that has not started yet; calls before its start share it */
  #next: Promise<void> | null = null;
  #newest: Promise<void> = Promise.resolve();
  /** number of deletions, and how many of them are erased */
  #deletions = 0;
  #erased = 0;

  constructor(redis: Redis) {
    this.#redis = redis;
  }

  /** Notes a deletion that Redis has stored. */
  deleted(): void {
    this.#deletions += 1;
  }

  /**
   * Erases what was deleted before this call. After a failure, the next call tries again.
   * @returns once the files contain none of it
   * @throws StoreUnavailableError if Redis did not rewrite its file
   */
  async sweep(): Promise<void> {
    if (this.#erased === this.#deletions) return;
    this.#next ??= this.#afterNewest();
    await this.#next;
  }

  async #afterNewest(): Promise<void> {
    const before = this.#newest;
    const next = before.catch(() => undefined).then(() => this.#rewrite());
    this.#newest = next;
    return next;
  }

  async #rewrite(): Promise<void> {
    const deletions = await this.#begin().finally(() => {
      this.#next = null;
    });
    const info = await this.#untilIdle();
    if (valueIn(info, "aof_last_bgrewrite_status") !== "ok") {
      throw new StoreUnavailableError("Redis failed to rewrite its append-only file");
    }
    this.#erased = deletions;
  }

  /** Starts a rewrite. @returns number of deletions before it */
  async #begin(): Promise<number> {
    for (;;) {
      // A rewrite by another relay may have started before the deletion.
      await this.#untilIdle();
      const deletions = this.#deletions;
      try {
        await asked(this.#redis.bgRewriteAof());
        return deletions;
      } catch (error) {
        const isBegun = error instanceof ErrorReply && /in progress/.test(error.message);
        if (!isBegun) throw error;
      }
    }
  }

  /** Waits for the end of the current rewrite. @returns the newest response to INFO */
  async #untilIdle(): Promise<string> {
    for (let ms = POLL_MS; ; ms = Math.min(1_000, ms * 1.5)) {
      const info = await asked(this.#redis.info("persistence"));
      const fields = ["aof_rewrite_in_progress", "aof_rewrite_scheduled"];
      if (fields.every((field) => valueIn(info, field) !== "1")) return info;
      await pause(ms);
    }
  }
}
