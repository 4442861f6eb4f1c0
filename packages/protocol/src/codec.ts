/**
 * Messages to text and back. Reading is the only place where a frame is parsed, and it never throws:
 * the result is the message or a list of what is wrong with it.
 */
import type { z } from "zod";
import { readJson, type ReadResult } from "./document-reader.ts";
import type {
  DriverToRelay,
  Hello,
  PageToRelay,
  RelayToDriver,
  RelayToPage,
  Resume,
} from "./messages.ts";

/** Largest message, and largest body of a request, in bytes. */
export const MAX_FRAME_BYTES = 16 * 1024;
/** Largest first message, before anyone is known, in bytes. */
export const MAX_HELLO_BYTES = 1024;

type Frame = Hello | Resume | PageToRelay | RelayToPage | DriverToRelay | RelayToDriver;

/** The message as one JSON text. */
export function encodeFrame(frame: Frame): string {
  return JSON.stringify(frame);
}

/**
 * Reads one message.
 * @param schema the messages that may come from that side, such as `pageToRelaySchema`
 */
export function decodeFrame<T>(
  schema: z.ZodType<T>,
  text: string,
  maxLength: number = MAX_FRAME_BYTES,
): ReadResult<T> {
  return readJson(schema, text, maxLength);
}
