/**
 * Reads messages from scripts and viewers. Most of them are `seen` acknowledgements, one per
 * snapshot: a hand-written parser reads these, and the schema reads all others.
 */
import { decodeFrame } from "./codec.ts";
import type { ReadResult } from "./document-reader.ts";
import { driverToRelaySchema, type DriverToRelay } from "./messages.ts";

const BEFORE_SEQ = '{"type":"seen","seq":';
/** Always a safe integer. */
const MAX_DIGITS = 15;

/** Reads a message of a script or viewer that has sent its `hello`. */
export function decodeDriverFrame(text: string): ReadResult<DriverToRelay> {
  const seq = readPlainSeen(text);
  if (seq !== null) return { ok: true, value: { type: "seen", seq } };
  return decodeFrame(driverToRelaySchema, text);
}

/** @returns `seq` of a `seen` as JSON.stringify writes it; null for any other text, valid or not */
export function readPlainSeen(text: string): number | null {
  const digits = text.length - BEFORE_SEQ.length - 1;
  if (digits < 1 || digits > MAX_DIGITS) return null;
  if (!text.startsWith(BEFORE_SEQ) || !text.endsWith("}")) return null;
  let seq = 0;
  for (let at = BEFORE_SEQ.length; at < text.length - 1; at++) {
    const digit = text.charCodeAt(at) - 48;
    if (digit < 0 || digit > 9) return null;
    seq = seq * 10 + digit;
  }
  // JSON permits no leading zeros.
  return digits > 1 && text.charAt(BEFORE_SEQ.length) === "0" ? null : seq;
}
