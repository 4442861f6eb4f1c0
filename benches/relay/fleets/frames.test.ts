import { once } from "node:events";
import type { AddressInfo } from "node:net";
import { describe, expect, it, onTestFinished } from "vitest";
import { WebSocketServer } from "ws";
import { frameOf, PING, takeFrames, TEXT, type Frame } from "./frames.ts";
import { TextWire } from "./text-wire.ts";

function serverFrame(text: string): Buffer {
  const payload = Buffer.from(text);
  const head =
    payload.length < 126
      ? Buffer.from([0x81, payload.length])
      : Buffer.from([0x81, 126, payload.length >> 8, payload.length & 0xff]);
  return Buffer.concat([head, payload]);
}

describe("frames", () => {
  it("are taken off a stream however it was cut", () => {
    const texts = ["a", "b".repeat(125), "c".repeat(126), "", "d".repeat(3000)];
    const stream = Buffer.concat(texts.map(serverFrame));
    for (const size of [1, 2, 3, 100, stream.length]) {
      const taken: Frame[] = [];
      let rest = Buffer.alloc(0);
      for (let at = 0; at < stream.length; at += size) {
        const bytes = Buffer.concat([rest, stream.subarray(at, at + size)]);
        rest = Buffer.from(
          takeFrames(bytes, ({ opcode, payload }) => {
            taken.push({ opcode, payload: Buffer.from(payload) });
          }),
        );
      }
      expect(taken.map(({ payload }) => payload.toString())).toEqual(texts);
      expect(rest).toHaveLength(0);
    }
  });

  it("say their length, and are masked", () => {
    expect(frameOf(TEXT, Buffer.alloc(200))[1]).toBe(0x80 | 126);
    expect([...frameOf(PING, Buffer.from([0x37, 0xfb])).subarray(6)]).toEqual([0, 1]);
  });
});

describe("a wire", () => {
  it("says to a WebSocket server what it is given, hears it, and answers its pings", async () => {
    const server = new WebSocketServer({ port: 0, host: "127.0.0.1" });
    onTestFinished(() => server.close());
    server.on("connection", (socket, { url }) => {
      socket.on("message", (data: Buffer) => socket.send(`${url} ${data.toString()}`));
      socket.on("pong", () => socket.send("pong"));
    });
    await once(server, "listening");
    const heard: string[] = [];
    const { promise: all, resolve } = Promise.withResolvers<void>();
    const wire = await TextWire.open({
      port: (server.address() as AddressInfo).port,
      path: "/here",
      headers: {},
      hear: (text) => {
        heard.push(text);
        if (heard.length === 3) resolve();
      },
    });
    wire.send("x");
    wire.send("y".repeat(500));
    for (const socket of server.clients) socket.ping("still there?");
    await all;
    expect(new Set(heard)).toEqual(new Set(["/here x", `/here ${"y".repeat(500)}`, "pong"]));
    wire.close();
  });
});
