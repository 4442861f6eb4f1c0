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
import { classMessageSchema, type ClassMessage } from "./class-message.ts";
import { classRecordSchema } from "./class-record.ts";

const publishedSchema = z.discriminatedUnion("kind", [
  z.object({
    kind: z.literal("changes"),
    version: z.int(),
    changes: z.object({
      row: classRow,
      students: z.array(studentRow),
      removed: z.array(z.int()),
    }),
    events: z.array(classRecordSchema),
  }),
  z.object({ kind: z.literal("over") }),
  z.object({ kind: z.literal("message"), from: z.string(), message: classMessageSchema }),
]);

export interface RedisClassBusOptions {
  redis: Redis;
  /** the connection for subscriptions, which other buses share */
  subscriber: Redis;
  /** name of this relay */
  relay: string;
  log: Logger;
}

export class RedisClassBus implements ClassBus {
  readonly #options: RedisClassBusOptions;
  /** start of this relay's own messages, which it ignores */
  readonly #ownMessage: string;
  readonly #listeners = new Set<ClassListener>();

  constructor(options: RedisClassBusOptions) {
    this.#options = options;
    this.#ownMessage = JSON.stringify({ kind: "message", from: options.relay }).slice(0, -1);
    // The client resubscribes automatically, but messages in between are lost.
    options.subscriber.on("ready", () => {
      for (const listener of this.#listeners) listener.missed();
    });
  }

  async join(id: string, listener: ClassListener): Promise<ClassChannel> {
    const { subscriber, log } = this.#options;
    const channel = classChannelOf(id);
    const onMessage = (text: string): void => {
      if (text.startsWith(this.#ownMessage)) return;
      const read = publishedSchema.safeParse(JSON.parse(text));
      if (!read.success) log.warn({ err: read.error }, "invalid message from another relay");
      else if (read.data.kind === "over") listener.over();
      else if (read.data.kind === "changes") listener.committed(read.data);
      else listener.received(read.data.message, read.data.from);
    };
    await asked(subscriber.subscribe(channel, onMessage));
    this.#listeners.add(listener);
    return {
      // The store has published both.
      committed: () => undefined,
      over: () => undefined,
      notify: (message) => this.#publish(channel, message),
      leave: () => {
        this.#listeners.delete(listener);
        subscriber.unsubscribe(channel, onMessage).catch(() => undefined);
      },
    };
  }

  #publish(channel: string, message: ClassMessage): void {
    const { redis, relay, log } = this.#options;
    const text = JSON.stringify({ kind: "message", from: relay, message });
    redis.publish(channel, text).catch((error: unknown) => {
      log.debug({ err: error }, "publishing to other relays failed");
    });
  }
}
