/**
 * Takes what was deleted out of the files of Redis. Its append-only file tells how things came about, so
 * a deletion is one more line in it; only writing it anew leaves the deleted out.
 */
import { setTimeout as pause } from "node:timers/promises";
import { ErrorReply } from "@redis/client";
import { asked, type Redis } from "./connection.ts";
import { valueIn } from "./durability.ts";

const POLL_MS = 20;

export class ForgottenBytes {
  readonly #redis: Redis;
  /** what has not begun yet: whoever comes before it begins may share it */
  #next: Promise<void> | null = null;
  #newest: Promise<void> = Promise.resolve();

  constructor(redis: Redis) {
    this.#redis = redis;
  }

  /** @returns once the files hold nothing any more that was deleted before this call */
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
      // One that another relay has begun may have begun before our deletion.
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
