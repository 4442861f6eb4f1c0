/**
 * Message bus for classes over Redis. The store publishes commits and deletions in the transaction
 * that makes them. A broken connection makes the bus call `missed`.
 */
import { progressRecordSchema, studentViewSchema, tileSchema } from "@corridor/protocol";
import type { Logger } from "pino";
import { z } from "zod";
import { classRow, studentRow } from "../store/class-rows.ts";
import { asked, type Redis } from "../store/redis/connection.ts";
import { classChannelOf } from "../store/redis/redis-keys.ts";
import type { ClassBus, ClassChannel, ClassListener } from "./class-bus.ts";

const student = z.int();
const newsSchema = z.object({
  kind: z.literal("changes"),
  version: z.int(),
  changes: z.object({ row: classRow, students: z.array(studentRow), removed: z.array(student) }),
  events: z.array(
    z.discriminatedUnion("type", [
      z.object({
        type: z.literal("student"),
        student: studentViewSchema,
        progress: progressRecordSchema.nullable(),
      }),
      z.object({ type: z.literal("removed"), student }),
    ]),
  ),
});
const tile = z.object({ student, connected: z.boolean(), tile: tileSchema.nullable() });
const messageSchema = z.discriminatedUnion("kind", [
  z.object({
    kind: z.literal("here"),
    connected: z.array(student),
    watched: z.array(student),
    asks: z.boolean(),
  }),
  z.object({ kind: z.literal("connected"), student }),
  z.object({ kind: z.literal("tiles"), tiles: z.array(tile) }),
  z.object({ kind: z.literal("hint"), student, task: z.int(), hint: z.int() }),
  z.object({ kind: z.literal("display"), content: z.looseObject({}) }),
  z.object({ kind: z.literal("left") }),
  z.object({ kind: z.literal("over") }),
]);
const envelopeSchema = z.object({ from: z.string(), message: messageSchema });
/** The store knows neither its relay nor the envelope: it publishes the text of the commit. */
const publishedSchema = z.union([envelopeSchema, newsSchema]);

export interface RedisClassBusOptions {
  redis: Redis;
  /** the connection for subscriptions, which other buses share */
  subscriber: Redis;
  relay: string;
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
    const { redis, subscriber, relay, log } = this.#options;
    const channel = classChannelOf(id);
    const onMessage = (text: string): void => {
      const read = publishedSchema.safeParse(JSON.parse(text));
      if (!read.success) log.warn({ err: read.error }, "invalid message from another relay");
      else if ("kind" in read.data) listener.news(read.data);
      else if (read.data.from !== relay) listener.received(read.data.message, read.data.from);
    };
    await asked(subscriber.subscribe(channel, onMessage));
    this.#listeners.add(listener);
    return {
      // The store has published it.
      committed: () => undefined,
      notify: (message) => {
        const text = JSON.stringify({ from: relay, message });
        redis.publish(channel, text).catch((error: unknown) => {
          log.debug({ err: error }, "publishing to other relays failed");
        });
      },
      leave: () => {
        if (!this.#listeners.delete(listener)) return;
        subscriber.unsubscribe(channel, onMessage).catch(() => undefined);
        const text = JSON.stringify({ from: relay, message: { kind: "left" } });
        redis.publish(channel, text).catch(() => undefined);
      },
    };
  }
}
