/**
 * Long-poll connections, for networks that block WebSockets. Clients post and fetch the same
 * messages. Each side numbers its messages 1, 2, 3, ..., so that a failed request can be repeated
 * safely.
 */
import { z } from "zod";
import { keySchema } from "./registration.ts";

/** Messages per request or response. */
export const MAX_LONG_POLL_MESSAGES = 64;

const number = z
  .int({ error: "a whole number" })
  .min(1, { error: "1 or more" })
  .max(Number.MAX_SAFE_INTEGER, { error: "a whole number below 2^53" });

const message = z.looseObject({ type: z.string() }, { error: "a message with a type" });
const messages = z
  .array(message, { error: "a list of messages" })
  .max(MAX_LONG_POLL_MESSAGES, { error: `at most ${MAX_LONG_POLL_MESSAGES} messages` });

/** The response to the `hello` that opens a connection. */
export const openedConnectionSchema = z.strictObject({
  /** the bearer key of this connection only */
  key: keySchema,
});
export type OpenedConnection = z.infer<typeof openedConnectionSchema>;

/** Messages of a client. The relay ignores messages that it already received. */
export const sentMessagesSchema = z.strictObject({
  /** number of the first message */
  first: number,
  messages,
});
export type SentMessages = z.infer<typeof sentMessagesSchema>;

/** The number of the last message that the relay received. */
export const takenMessagesSchema = z.strictObject({
  taken: z.int().min(0).max(Number.MAX_SAFE_INTEGER),
});
export type TakenMessages = z.infer<typeof takenMessagesSchema>;

/** Messages of the relay. */
export const fetchedMessagesSchema = z.strictObject({
  /** number of the first message, or of the next one if there are none */
  first: number,
  messages,
  /** the WebSocket close code of a closed connection; null while it is open */
  closed: z.strictObject({ code: z.int(), reason: z.string().max(200) }).nullable(),
});
export type FetchedMessages = z.infer<typeof fetchedMessagesSchema>;
