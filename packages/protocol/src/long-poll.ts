/**
 * A line by plain HTTPS, for networks that let no WebSocket through: the messages are the same, posted
 * and fetched by long poll. Each side numbers what it sends, 1, 2, 3, so that a request that failed can
 * be sent again.
 */
import { z } from "zod";
import { keySchema } from "./registration.ts";

/** Messages in one request or answer. */
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
  /** the bearer key of this connection alone */
  key: keySchema,
});
export type OpenedConnection = z.infer<typeof openedConnectionSchema>;

/** What a client sends; what was sent before is taken once. */
export const sentMessagesSchema = z.strictObject({
  /** number of the first of them */
  first: number,
  messages,
});
export type SentMessages = z.infer<typeof sentMessagesSchema>;

/** How far the relay has taken what was sent. */
export const takenMessagesSchema = z.strictObject({
  taken: z.int().min(0).max(Number.MAX_SAFE_INTEGER),
});
export type TakenMessages = z.infer<typeof takenMessagesSchema>;

/** What a client fetches. */
export const fetchedMessagesSchema = z.strictObject({
  /** number of the first of them, or of the next to come */
  first: number,
  messages,
  /** why the line is closed, by a WebSocket's close code; null while it is open */
  closed: z.strictObject({ code: z.int(), reason: z.string().max(200) }).nullable(),
});
export type FetchedMessages = z.infer<typeof fetchedMessagesSchema>;
