/**
 * Fast path for the usual WebSocket message: a short, uncompressed text in one frame. It avoids the
 * stream and the buffers that `ws` uses for each part of a frame.
 *
 * All other bytes are passed to `ws` unchanged. Pings and pongs are passed one by one. After a
 * fragmented message, a close frame or a protocol error, `ws` receives the rest of the stream, so
 * that only `ws` handles these cases.
 */
import { isUtf8 } from "node:buffer";
import type { Duplex } from "node:stream";
import { MAX_FRAME_BYTES } from "@corridor/protocol";

const FINAL_TEXT = 0x81;
const PING = 0x89;
const PONG = 0x8a;
/** bit of the second byte that is set if the payload is masked, as required of clients */
const IS_MASKED = 0x80;
const LENGTH_BITS = 0x7f;
const TWO_BYTE_LENGTH = 126;
const EIGHT_BYTE_LENGTH = 127;
const MASK_BYTES = 4;

/**
 * Replaces the data listener of `ws` on a connection that was just opened.
 * @param onText receives each text in order, in a buffer that it owns
 */
export function readPlainTexts(connection: Duplex, onText: (bytes: Buffer) => void): void {
  const [listener] = connection.listeners("data");
  if (listener === undefined) throw new Error("the connection has no data listener");
  connection.off("data", listener as (chunk: Buffer) => void);
  const passOn = (bytes: Buffer): void => {
    Reflect.apply(listener, connection, [bytes]);
  };
  const onData = (chunk: Buffer): void => {
    // `ws` itself reads what remains after an error.
    if (!connection.destroyed) reader.read(chunk);
  };
  const reader = new PlainTextReader(onText, passOn, () => {
    // `ws` removes its own listener when it needs to, and then receives the end of the stream.
    connection.off("data", onData);
    connection.on("data", listener as (chunk: Buffer) => void);
  });
  connection.on("data", onData);
}

class PlainTextReader {
  readonly #onText: (bytes: Buffer) => void;
  readonly #passOn: (bytes: Buffer) => void;
  /** the start of an incomplete frame */
  #partial: Buffer | null = null;
  readonly #onDetach: () => void;
  #isDetached = false;

  /**
   * @param passOn receives the bytes for `ws`
   * @param onDetach called before all further bytes are passed on
   */
  constructor(
    onText: (bytes: Buffer) => void,
    passOn: (bytes: Buffer) => void,
    onDetach: () => void,
  ) {
    this.#onText = onText;
    this.#passOn = passOn;
    this.#onDetach = onDetach;
  }

  read(chunk: Buffer): void {
    const bytes = this.#partial === null ? chunk : Buffer.concat([this.#partial, chunk]);
    this.#partial = null;
    let at = 0;
    while (at < bytes.length) {
      const end = this.#readFrame(bytes, at);
      if (this.#isDetached) return this.#passOn(bytes.subarray(at));
      if (end === null) {
        this.#partial = bytes.subarray(at);
        return;
      }
      at = end;
    }
  }

  /**
   * @returns the end of the frame, or null if the frame is incomplete or the reader has detached
   */
  #readFrame(bytes: Buffer, at: number): number | null {
    const [first, second] = [bytes[at], bytes[at + 1]];
    if (first === undefined || second === undefined) return null;
    const short = second & LENGTH_BITS;
    const isText = first === FINAL_TEXT;
    const isPlain = isText
      ? short !== EIGHT_BYTE_LENGTH
      : isHeartbeat(first) && short < TWO_BYTE_LENGTH;
    if (!isPlain || (second & IS_MASKED) === 0) return this.#detach();
    const mask = at + (short === TWO_BYTE_LENGTH ? 4 : 2);
    const start = mask + MASK_BYTES;
    if (bytes.length < start) return null;
    const length = short === TWO_BYTE_LENGTH ? bytes.readUInt16BE(at + 2) : short;
    if (length > MAX_FRAME_BYTES) return this.#detach();
    const end = start + length;
    if (bytes.length < end) return null;
    if (!isText) {
      this.#passOn(bytes.subarray(at, end));
      return end;
    }
    applyMask(bytes, mask, end);
    const text = bytes.subarray(start, end);
    if (!isUtf8(text)) {
      applyMask(bytes, mask, end);
      return this.#detach();
    }
    this.#onText(text);
    return end;
  }

  #detach(): null {
    this.#isDetached = true;
    this.#onDetach();
    return null;
  }
}

/** A ping or a pong, which may occur between any two frames. */
function isHeartbeat(first: number): boolean {
  return first === PING || first === PONG;
}

/**
 * Applies the four-byte mask at `mask` to the payload after it. Applying it twice restores the
 * payload.
 */
function applyMask(bytes: Buffer, mask: number, end: number): void {
  const a = bytes[mask] ?? 0;
  const b = bytes[mask + 1] ?? 0;
  const c = bytes[mask + 2] ?? 0;
  const d = bytes[mask + 3] ?? 0;
  let at = mask + MASK_BYTES;
  for (; at + 4 <= end; at += 4) {
    bytes[at] = (bytes[at] ?? 0) ^ a;
    bytes[at + 1] = (bytes[at + 1] ?? 0) ^ b;
    bytes[at + 2] = (bytes[at + 2] ?? 0) ^ c;
    bytes[at + 3] = (bytes[at + 3] ?? 0) ^ d;
  }
  for (let n = 0; at < end; at++, n++) bytes[at] = (bytes[at] ?? 0) ^ (bytes[mask + n] ?? 0);
}
