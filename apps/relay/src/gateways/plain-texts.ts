/**
 * Reads messages of a WebSocket as nearly all of them come: a text in one frame, uncompressed, and short. That costs
 * less than the way through `ws`, which has a stream of its own for what comes in and a buffer for each part of a frame.
 *
 * It gets all else, byte by byte as it came: pings and pongs by themselves, and from a message in pieces, a goodbye or
 * anything that is wrong on all that follows. So there is one place that answers these, and it is not here.
 */
import { isUtf8 } from "node:buffer";
import type { Duplex } from "node:stream";
import { MAX_FRAME_BYTES } from "@corridor/protocol";

const WHOLE_TEXT = 0x81;
const PING = 0x89;
const PONG = 0x8a;
/** of the second byte: the client masks, as it must */
const IS_MASKED = 0x80;
const LENGTH = 0x7f;
const IN_TWO = 126;
const IN_EIGHT = 127;
const MASK_BYTES = 4;

/**
 * Listens in the place of `ws` on a connection that was just opened.
 * @param hear gets each text, in the order of all messages; the bytes are its own
 */
export function hearPlainTexts(connection: Duplex, hear: (bytes: Buffer) => void): void {
  const [listener] = connection.listeners("data");
  if (listener === undefined) throw new Error("nobody reads this connection");
  connection.off("data", listener as (chunk: Buffer) => void);
  const leave = (bytes: Buffer): void => {
    Reflect.apply(listener, connection, [bytes]);
  };
  const ours = (chunk: Buffer): void => {
    // What is left behind by a broken line `ws` asks for itself.
    if (!connection.destroyed) reader.take(chunk);
  };
  const reader = new PlainTexts(hear, leave, () => {
    // It takes its own listener away where it has enough, and sees the end of the line then.
    connection.off("data", ours);
    connection.on("data", listener as (chunk: Buffer) => void);
  });
  connection.on("data", ours);
}

class PlainTexts {
  readonly #hear: (bytes: Buffer) => void;
  readonly #leave: (bytes: Buffer) => void;
  /** the beginning of a frame whose end has not come */
  #begun: Buffer | null = null;
  readonly #goes: () => void;
  #leavesAll = false;

  /**
   * @param leave gets what is for `ws`
   * @param goes is called when all that follows is, before that
   */
  constructor(hear: (bytes: Buffer) => void, leave: (bytes: Buffer) => void, goes: () => void) {
    this.#hear = hear;
    this.#leave = leave;
    this.#goes = goes;
  }

  take(chunk: Buffer): void {
    const bytes = this.#begun === null ? chunk : Buffer.concat([this.#begun, chunk]);
    this.#begun = null;
    let at = 0;
    while (at < bytes.length) {
      const end = this.#takeFrame(bytes, at);
      if (this.#leavesAll) return this.#leave(bytes.subarray(at));
      if (end === null) {
        this.#begun = bytes.subarray(at);
        return;
      }
      at = end;
    }
  }

  /** @returns where the frame ends; null: that has not come yet, or all from here on is for `ws` */
  #takeFrame(bytes: Buffer, at: number): number | null {
    const [first, second] = [bytes[at], bytes[at + 1]];
    if (first === undefined || second === undefined) return null;
    const short = second & LENGTH;
    const isText = first === WHOLE_TEXT;
    const isPlain = isText ? short !== IN_EIGHT : isBeat(first) && short < IN_TWO;
    if (!isPlain || (second & IS_MASKED) === 0) return this.#leaveAll();
    const mask = at + (short === IN_TWO ? 4 : 2);
    const start = mask + MASK_BYTES;
    if (bytes.length < start) return null;
    const length = short === IN_TWO ? bytes.readUInt16BE(at + 2) : short;
    if (length > MAX_FRAME_BYTES) return this.#leaveAll();
    const end = start + length;
    if (bytes.length < end) return null;
    if (!isText) {
      this.#leave(bytes.subarray(at, end));
      return end;
    }
    turn(bytes, mask, end);
    const text = bytes.subarray(start, end);
    if (!isUtf8(text)) {
      turn(bytes, mask, end);
      return this.#leaveAll();
    }
    this.#hear(text);
    return end;
  }

  #leaveAll(): null {
    this.#leavesAll = true;
    this.#goes();
    return null;
  }
}

/** A ping or a pong, which may stand between any two frames. */
function isBeat(first: number): boolean {
  return first === PING || first === PONG;
}

/** Puts a mask of four bytes on the message behind it, or takes it off, which is the same. */
function turn(bytes: Buffer, mask: number, end: number): void {
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
