/** A Lua script that Redis runs as one atomic step. Arguments and result are JSON. */
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { ErrorReply } from "@redis/client";
import { asked, type Redis } from "./connection.ts";

export class Script {
  readonly #redis: Redis;
  readonly #text: string;
  readonly #hash: string;
  readonly #always: readonly string[];

  /**
   * @param files in the folder of this module, joined in this order
   * @param always additional arguments of every step
   */
  constructor(redis: Redis, files: readonly string[], always: readonly string[] = []) {
    this.#always = always;
    this.#redis = redis;
    const texts = files.map((file) => readFileSync(join(import.meta.dirname, file), "utf8"));
    this.#text = texts.join("\n");
    this.#hash = createHash("sha1").update(this.#text).digest("hex");
  }

  /** Runs one step of the script. */
  async run(step: string, keys: string[], values: unknown): Promise<unknown> {
    const answer = await this.call(keys, [step, JSON.stringify(values), ...this.#always]);
    return typeof answer === "string" ? JSON.parse(answer) : answer;
  }

  /** Runs the script. Calls run in the order in which they were made. */
  async call(keys: string[], words: string[]): Promise<unknown> {
    const options = { keys, arguments: words };
    return asked(
      this.#redis.evalSha(this.#hash, options).catch((error: unknown) => {
        const isUnknown = error instanceof ErrorReply && error.message.startsWith("NOSCRIPT");
        if (!isUnknown) throw error;
        return this.#redis.eval(this.#text, options);
      }),
    );
  }
}
