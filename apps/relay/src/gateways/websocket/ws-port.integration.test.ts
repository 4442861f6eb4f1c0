import { once } from "node:events";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import type { Duplex } from "node:stream";
import { closeReasons } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it, onTestFinished } from "vitest";
import { WebSocket, WebSocketServer } from "ws";
import { CarriedSnapshot } from "../../bus/carried-snapshot.ts";
import { limits } from "../../platform/limits/limits.ts";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import { WsPort } from "./ws-port.ts";

/** A port and its client, with everything that the client received in order. */
async function opened() {
  const server = createServer().listen(0, "127.0.0.1");
  await once(server, "listening");
  const sockets = new WebSocketServer({ noServer: true, perMessageDeflate: false });
  const { promise, resolve } = Promise.withResolvers<{ port: WsPort; line: Duplex }>();
  server.on("upgrade", (request, line: Duplex, head) => {
    sockets.handleUpgrade(request, line, head, (socket) =>
      resolve({ port: new WsPort(socket, line, new FakeClock()), line }),
    );
  });
  const client = new WebSocket(`ws://127.0.0.1:${(server.address() as AddressInfo).port}`);
  onTestFinished(() => {
    client.terminate();
    server.close();
  });
  const sent: string[] = [];
  client.on("message", (data: Buffer, isBinary) => {
    sent.push(isBinary ? "bytes" : data.toString());
  });
  client.on("ping", () => sent.push("a ping"));
  client.on("close", (code) => sent.push(`closed with ${code}`));
  const [{ port, line }] = await Promise.all([promise, once(client, "open")]);
  return { port, line, client, sent };
}

describe("a WebSocket connection", () => {
  it.each([
    { name: "an empty text", text: "" },
    { name: "125 bytes", text: "a".repeat(125) },
    { name: "126 bytes", text: "a".repeat(126) },
    { name: "65,535 bytes", text: "a".repeat(65_535) },
    { name: "65,536 bytes", text: "a".repeat(65_536) },
    { name: "126 bytes of multi-byte characters", text: "→".repeat(42) },
    { name: "65,535 bytes of multi-byte characters", text: "→".repeat(21_845) },
    { name: "65,536 bytes of multi-byte characters", text: "🤖".repeat(16_384) },
  ])("sends a text in one write, as every client reads it: $name", async ({ text }) => {
    const { port, line, client, sent } = await opened();
    const before = port.sentBytes;
    let writes = 0;
    const write = line.write.bind(line);
    line.write = (chunk: Buffer) => {
      writes += 1;
      return write(chunk);
    };
    port.send(text);
    await once(client, "message");
    expect(sent).toEqual([text]);
    expect(writes).toBe(1);
    expect(port.sentBytes - before).toBeGreaterThanOrEqual(Buffer.byteLength(text));
  });

  it("sends several texts in one write, as separate messages", async () => {
    const { port, line, client, sent } = await opened();
    let writes = 0;
    const write = line.write.bind(line);
    line.write = (chunk: Buffer) => {
      writes += 1;
      return write(chunk);
    };
    const texts = ["one", "é".repeat(200), "", "x".repeat(70_000), "last"];
    port.send();
    port.send(...texts);
    await expect.poll(() => sent).toEqual(texts);
    expect(writes).toBe(1);
    const { sentBytes } = port;
    port.ask();
    await expect.poll(() => port.takenBytes).toBe(sentBytes);
    client.terminate();
  });

  it("keeps the order of messages", async () => {
    const { port, client, sent } = await opened();
    const long = "x".repeat(300_000);
    const snapshot = CarriedSnapshot.of(snapshotOf({ seq: 1 }));
    port.send("first");
    port.ask();
    port.send(long);
    port.sendSnapshot(snapshot);
    port.send("last");
    port.close(1000, "that is all");
    port.send("too late");
    port.sendSnapshot(snapshot);
    await once(client, "close");
    const passed = String(snapshot.message);
    expect(sent).toEqual(["first", "a ping", long, passed, "last", "closed with 1000"]);
  });

  it("reports what the client has received, to the byte", async () => {
    const { port, client } = await opened();
    port.send("é".repeat(100));
    port.sendSnapshot(CarriedSnapshot.of(snapshotOf({ seq: 1 })));
    const { sentBytes } = port;
    port.ask();
    await expect.poll(() => port.takenBytes).toBe(sentBytes);
    client.terminate();
  });

  it("closes for a client that does not read, with a bounded buffer", async () => {
    const { port, client, sent } = await opened();
    client.pause();
    const text = "x".repeat(100_000);
    let most = 0;
    // The network itself buffers some megabytes.
    for (let sent = 0; port.isOpen && sent < 1_000; sent++) {
      port.send(text);
      most = Math.max(most, port.waitingBytes);
      await new Promise((resolve) => void setImmediate(resolve));
    }
    expect(port.isOpen).toBe(false);
    expect(most).toBeLessThan(limits.stuckReaderBytes + 2 * text.length);
    client.resume();
    await once(client, "close");
    expect(sent.at(-1)).toBe(`closed with ${closeReasons.tooSlow.code}`);
    expect(new Set(sent.slice(0, -1))).toEqual(new Set([text]));
  });
});
