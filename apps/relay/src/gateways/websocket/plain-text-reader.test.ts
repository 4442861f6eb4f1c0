import type { IncomingMessage } from "node:http";
import { duplexPair } from "node:stream";
import { MAX_FRAME_BYTES } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { WebSocketServer, type WebSocket } from "ws";
import { readPlainTexts } from "./plain-text-reader.ts";

const [MORE, TEXT, BYTES, CLOSE_FRAME, PING, PONG] = [0, 1, 2, 8, 9, 10];
const WHOLE = 0x80;

interface Shape {
  /** default: an unfragmented text */
  first?: number;
  /** default: true */
  isMasked?: boolean;
  /** bytes of the length field; default: the minimum */
  lengthIn?: 1 | 2 | 8;
}

/** Encodes a frame as a client sends it. */
function frame(message: string | Buffer, shape: Shape = {}): Buffer {
  const bytes = Buffer.from(message);
  const { first = WHOLE | TEXT, isMasked = true } = shape;
  const { lengthIn = bytes.length < 126 ? 1 : bytes.length < 65_536 ? 2 : 8 } = shape;
  const header = Buffer.alloc(lengthIn === 1 ? 2 : 2 + lengthIn);
  header[0] = first;
  header[1] = (isMasked ? 0x80 : 0) | { 1: bytes.length, 2: 126, 8: 127 }[lengthIn];
  if (lengthIn === 2) header.writeUInt16BE(bytes.length, 2);
  if (lengthIn === 8) header.writeBigUInt64BE(BigInt(bytes.length), 2);
  if (!isMasked) return Buffer.concat([header, bytes]);
  const mask = Buffer.from([0x37, 0xfa, 0x21, 0x3d]);
  return Buffer.concat([header, mask, bytes.map((byte, at) => byte ^ (mask[at & 3] ?? 0))]);
}

function nextTurn(): Promise<void> {
  return new Promise((resolve) => void setImmediate(resolve));
}

/** Received texts and sent bytes of a socket that receives these bytes in a number of pieces. */
async function receive(bytes: Buffer, pieces: number, isPlain: boolean): Promise<unknown[]> {
  const [line, far] = duplexPair();
  const server = new WebSocketServer({
    noServer: true,
    perMessageDeflate: false,
    maxPayload: MAX_FRAME_BYTES,
  });
  const headers = {
    upgrade: "websocket",
    "sec-websocket-version": "13",
    "sec-websocket-key": "dGhlIHNhbXBsZSBub25jZQ==",
  };
  const answers: Buffer[] = [];
  far.on("data", (chunk: Buffer) => answers.push(chunk));
  const request = { method: "GET", headers } as unknown as IncomingMessage;
  const socket = await new Promise<WebSocket>((resolve) => {
    server.handleUpgrade(request, line, Buffer.alloc(0), resolve);
  });
  const all: unknown[] = [];
  const receive = (data: Buffer, isBinary: boolean): void => {
    all.push([isBinary ? "bytes" : "text", data.toString()]);
  };
  socket.on("message", receive);
  if (isPlain) readPlainTexts(line, (text) => receive(text, false));
  socket.on("ping", (data) => all.push(["ping", data.toString()]));
  socket.on("pong", (data) => all.push(["pong", data.toString()]));
  socket.on("error", ({ message }) => all.push(["error", message]));
  const closed = new Promise((resolve) => {
    socket.on("close", (code, reason) => resolve(["closed", code, reason.toString()]));
  });
  for (let at = 0; at < bytes.length; at += pieces) {
    // The buffer must not be shared, because it is unmasked in place.
    far.write(Buffer.from(bytes.subarray(at, at + pieces)));
    await nextTurn();
  }
  far.end();
  let isClosed = false;
  void closed.then(() => (isClosed = true));
  for (let moments = 0; moments < 20 && !isClosed; moments++) await nextTurn();
  // Without this, `ws` destroys an unclosed connection 30 s later.
  all.push(["closed by itself", isClosed]);
  line.destroy();
  all.push(await closed);
  const words = Buffer.concat(answers);
  return [...all, words.subarray(words.indexOf("\r\n\r\n") + 4).toString("hex")];
}

const last = frame("the last");
const lines: Record<string, Buffer[]> = {
  "short texts": [frame(""), frame("a"), frame("ab"), frame("abc"), frame("abcde"), last],
  "125 and 126 bytes": [frame("x".repeat(125)), frame("x".repeat(126)), last],
  "as much as may be": [frame("x".repeat(MAX_FRAME_BYTES)), last],
  "a byte too many": [frame("first"), frame("x".repeat(MAX_FRAME_BYTES + 1)), last],
  "far too much": [frame("first"), frame("x".repeat(70_000)), last],
  "letters of several bytes": [frame("höher → 🤖"), last],
  "no letters": [frame("first"), frame(Buffer.from([0x61, 0xff, 0xfe, 0x62])), last],
  "half a letter": [frame("first"), frame(Buffer.from([0xf0, 0x9f, 0xa4])), last],
  "bytes that are no text": [frame("first"), frame("b", { first: WHOLE | BYTES }), last],
  "pings and pongs between": [
    frame("first"),
    frame("p1", { first: WHOLE | PING }),
    frame("second"),
    frame("", { first: WHOLE | PONG }),
    frame("p2", { first: WHOLE | PING }),
    last,
  ],
  "a text in pieces, a ping among them": [
    frame("first"),
    frame("be", { first: TEXT }),
    frame("p", { first: WHOLE | PING }),
    frame("gin", { first: MORE }),
    frame("ning", { first: WHOLE | MORE }),
    last,
  ],
  "a text within a text": [frame("begin", { first: TEXT }), last],
  "a piece of nothing": [frame("first"), frame("x", { first: WHOLE | MORE }), last],
  "no mask": [frame("first"), frame("bare", { isMasked: false }), last],
  "a bit that nobody asked for": [frame("x", { first: WHOLE | TEXT | 0x40 }), last],
  "a kind that does not exist": [frame("first"), frame("x", { first: WHOLE | 3 }), last],
  "a ping that is too long": [frame("x".repeat(126), { first: WHOLE | PING }), last],
  "a ping in pieces": [frame("x", { first: PING }), last],
  "a length in more bytes than it needs": [
    frame("x", { lengthIn: 2 }),
    frame("y", { lengthIn: 8 }),
  ],
  "a close frame, and more": [
    frame("first"),
    frame(Buffer.from([0x03, 0xe8, 0x62, 0x79, 0x65]), { first: WHOLE | CLOSE_FRAME }),
    last,
  ],
  "a frame without an end": [frame("first"), frame("never whole").subarray(0, 9)],
  "half a header": [frame("first"), frame("x".repeat(200)).subarray(0, 3)],
};

describe("messages of a WebSocket", () => {
  it.each(Object.entries(lines))("are received as ws receives them: %s", async (_name, frames) => {
    const bytes = Buffer.concat(frames);
    for (const pieces of bytes.length < 500 ? [1, 3, 7, bytes.length] : [1_000, bytes.length]) {
      const expected = await receive(bytes, pieces, false);
      expect(await receive(bytes, pieces, true)).toEqual(expected);
    }
  });

  it("arrive one by one, even if many are in one chunk", async () => {
    const words = Array.from({ length: 300 }, (_, n) => `message ${n}`);
    const bytes = Buffer.concat(words.map((word) => frame(word)));
    const received = await receive(bytes, bytes.length, true);
    expect(received.slice(0, 300)).toEqual(words.map((word) => ["text", word]));
  });
});
