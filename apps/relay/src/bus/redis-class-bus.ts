/**
 * Message bus for classes over Redis. The store publishes commits and deletions in the transaction
 * that makes them. A broken connection makes the bus call `missed`.
 */
import type { Logger } from "pino";
import { z } from "zod";
import { classRow, studentRow } from "../store/class-rows.ts";
import { asked, type Redis } from "../store/redis/connection.ts";
import { classChannelOf } from "../store/redis/redis-keys.ts";
import type { ClassBus, ClassChannel, ClassListener } from "./class-bus.ts";
import { classRecordSchema } from "./class-record.ts";

const student = z.int();
const newsSchema = z.object({
  kind: z.literal("changes"),
  version: z.int(),
  changes: z.object({ row: classRow, students: z.array(studentRow), removed: z.array(student) }),
  events: z.array(classRecordSchema),
});
const publishedSchema = z.discriminatedUnion("kind", [
  newsSchema,
  z.object({ kind: z.literal("over") }),
]);

export interface RedisClassBusOptions {
  /** the connection for subscriptions, which other buses share */
  subscriber: Redis;
  log: Logger;
}

export class RedisClassBus implements ClassBus {
  readonly #options: RedisClassBusOptions;
  readonly #listeners = new Set<ClassListener>();

  constructor(options: RedisClassBusOptions) {
    this.#options = options;
    // The client resubscribes automatically, but messages in between are lost.
    options.subscriber.on("ready", () => {
      for (const listener of this.#listeners) listener.missed();
    });
  }

  async join(id: string, listener: ClassListener): Promise<ClassChannel> {
    const { subscriber, log } = this.#options;
    const channel = classChannelOf(id);
    const onMessage = (text: string): void => {
      const read = publishedSchema.safeParse(JSON.parse(text));
      if (!read.success) log.warn({ err: read.error }, "invalid message from another relay");
      else if (read.data.kind === "over") listener.over();
      else listener.news(read.data);
    };
    await asked(subscriber.subscribe(channel, onMessage));
    this.#listeners.add(listener);
    return {
      // The store has published both.
      committed: () => undefined,
      over: () => undefined,
      leave: () => {
        this.#listeners.delete(listener);
        subscriber.unsubscribe(channel, onMessage).catch(() => undefined);
      },
    };
  }
}
