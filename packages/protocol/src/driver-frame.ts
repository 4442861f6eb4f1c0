/**
 * Reading what a script or watcher says. Most of it is what it has seen, an answer to each snapshot, which
 * is read by hand; `driver-frame.test.ts` holds that to the schema, which reads all else.
 */
import { decodeFrame } from "./codec.ts";
import type { ReadResult } from "./document-reader.ts";
import { driverToRelaySchema, type DriverToRelay } from "./messages.ts";

const BEFORE_SEQ = '{"type":"seen","seq":';
/** So many digits are always a safe integer. */
const MOST_DIGITS = 15;

/** Reads a message of a script or watcher that has said hello. */
export function decodeDriverFrame(text: string): ReadResult<DriverToRelay> {
  const seq = readPlainSeen(text);
  if (seq !== null) return { ok: true, value: { type: "seen", seq } };
  return decodeFrame(driverToRelaySchema, text);
}

/** The number in a `seen` as JSON.stringify writes it; null for all else, which need not be wrong. */
export function readPlainSeen(text: string): number | null {
  const digits = text.length - BEFORE_SEQ.length - 1;
  if (digits < 1 || digits > MOST_DIGITS) return null;
  if (!text.startsWith(BEFORE_SEQ) || !text.endsWith("}")) return null;
  let seq = 0;
  for (let at = BEFORE_SEQ.length; at < text.length - 1; at++) {
    const digit = text.charCodeAt(at) - 48;
    if (digit < 0 || digit > 9) return null;
    seq = seq * 10 + digit;
  }
  // No number of JSON begins with a zero that could be left out.
  return digits > 1 && text.charAt(BEFORE_SEQ.length) === "0" ? null : seq;
}
