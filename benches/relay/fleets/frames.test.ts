import { once } from "node:events";
import type { AddressInfo } from "node:net";
import { describe, expect, it, onTestFinished } from "vitest";
import { WebSocketServer } from "ws";
import { decodeFrames, encodeFrame, PING, TEXT, type Frame } from "./frames.ts";
import { TextSocket } from "./text-socket.ts";

function serverFrame(text: string): Buffer {
  const payload = Buffer.from(text);
  const header =
    payload.length < 126
      ? Buffer.from([0x81, payload.length])
      : Buffer.from([0x81, 126, payload.length >> 8, payload.length & 0xff]);
  return Buffer.concat([header, payload]);
}

describe("frames", () => {
  it("are decoded from a stream that is split at any position", () => {
    const texts = ["a", "b".repeat(125), "c".repeat(126), "", "d".repeat(3000)];
    const stream = Buffer.concat(texts.map(serverFrame));
    for (const size of [1, 2, 3, 100, stream.length]) {
      const decoded: Frame[] = [];
      let remainder = Buffer.alloc(0);
      for (let at = 0; at < stream.length; at += size) {
        const bytes = Buffer.concat([remainder, stream.subarray(at, at + size)]);
        remainder = Buffer.from(
          decodeFrames(bytes, ({ opcode, payload }) => {
            decoded.push({ opcode, payload: Buffer.from(payload) });
          }),
        );
      }
      expect(decoded.map(({ payload }) => payload.toString())).toEqual(texts);
      expect(remainder).toHaveLength(0);
    }
  });

  it("are encoded with their length and a mask", () => {
    expect(encodeFrame(TEXT, Buffer.alloc(200))[1]).toBe(0x80 | 126);
    expect([...encodeFrame(PING, Buffer.from([0x37, 0xfb])).subarray(6)]).toEqual([0, 1]);
  });
});

describe("a text socket", () => {
  it("sends text to a WebSocket server, receives text, and answers pings", async () => {
    const server = new WebSocketServer({ port: 0, host: "127.0.0.1" });
    onTestFinished(() => server.close());
    server.on("connection", (socket, { url }) => {
      socket.on("message", (data: Buffer) => socket.send(`${url} ${data.toString()}`));
      socket.on("pong", () => socket.send("pong"));
    });
    await once(server, "listening");
    const received: string[] = [];
    const { promise: all, resolve } = Promise.withResolvers<void>();
    const client = await TextSocket.open({
      port: (server.address() as AddressInfo).port,
      path: "/here",
      headers: {},
      onMessage: (text) => {
        received.push(text);
        if (received.length === 3) resolve();
      },
    });
    client.send("x");
    client.send("y".repeat(500));
    for (const socket of server.clients) socket.ping("still there?");
    await all;
    expect(new Set(received)).toEqual(new Set(["/here x", `/here ${"y".repeat(500)}`, "pong"]));
    client.close();
  });
});
