import { once } from "node:events";
import { createServer, type Server } from "node:http";
import { connect, type AddressInfo } from "node:net";
import { expect, it, onTestFinished } from "vitest";
import { startBalancer } from "./balancer.ts";

/** Relays that answer each request with their own port and what they were sent. */
async function withRelays(count: number) {
  const relays = new Map<number, Server>();
  for (let n = 0; n < count; n++) {
    const relay = createServer((request, response) => {
      let body = "";
      request.on("data", (data: Buffer) => (body += data.toString()));
      request.on("end", () => response.end(JSON.stringify({ port, body })));
    });
    relay.on("upgrade", (request, socket) => {
      socket.end(`HTTP/1.1 101 ${request.headers.upgrade ?? ""} at ${port}\r\n\r\n`);
    });
    relay.listen(0, "127.0.0.1");
    await once(relay, "listening");
    const { port } = relay.address() as AddressInfo;
    relays.set(port, relay);
    onTestFinished(() => void relay.close());
  }
  const balancer = await startBalancer([...relays.keys()], 0, "127.0.0.1");
  onTestFinished(() => balancer.close());
  const ask = async (path: string, body?: string): Promise<{ port: number; body: string }> => {
    const url = `http://127.0.0.1:${balancer.port}/api/v1/robots/${path}`;
    const init = body === undefined ? {} : { method: "POST", body };
    return (await (await fetch(url, init)).json()) as { port: number; body: string };
  };
  const portsOf = async (paths: string[]): Promise<Set<number>> => {
    const ports = new Set<number>();
    for (const path of paths) ports.add((await ask(path)).port);
    return ports;
  };
  return { relays, balancer, ask, portsOf };
}

it("sends all of a line by HTTPS to one relay, whatever goes on beside it", async () => {
  const { ask, portsOf } = await withRelays(3);
  const ports = new Set<number>();
  for (let n = 0; n < 6; n++) {
    ports.add((await ask("robot-1/line/messages?after=0&wait=1")).port);
    ports.add((await ask("robot-1/line", '{"type":"hello"}')).port);
    await ask("robot-1/commands");
  }
  expect(ports.size).toBe(1);
  const others = Array.from({ length: 30 }, (_none, n) => `robot-${n}/line`);
  expect((await portsOf(others)).size).toBe(3);
});

it("sends other requests to each relay in turn, with what they say", async () => {
  const { ask, portsOf } = await withRelays(2);
  expect((await portsOf(["a/commands", "a/commands"])).size).toBe(2);
  expect(await ask("a/commands", '{"action":"stop"}')).toMatchObject({ body: '{"action":"stop"}' });
});

it("leaves a relay out that is gone, and the lines of the others where they are", async () => {
  const { relays, ask } = await withRelays(3);
  const paths = Array.from({ length: 20 }, (_none, n) => `robot-${n}/line`);
  const before = await Promise.all(paths.map(async (path) => (await ask(path)).port));
  const gone = before[0] ?? 0;
  relays.get(gone)?.close();
  relays.get(gone)?.closeAllConnections();
  const after = await Promise.all(paths.map(async (path) => (await ask(path)).port));
  expect(after).not.toContain(gone);
  const kept = paths.map((_path, n) => before[n] === gone || before[n] === after[n]);
  expect(kept).not.toContain(false);
});

it("cuts who waits for the answer of a relay that breaks off", async () => {
  const { relays, ask } = await withRelays(1);
  const [relay] = relays.values();
  relay?.removeAllListeners("request").on("request", (request) => void request.socket.destroy());
  await expect(ask("a/line/messages?after=0&wait=25")).rejects.toThrow(/fetch failed/);
});

it("joins whoever wants another protocol with a relay", async () => {
  const { balancer } = await withRelays(1);
  const socket = connect(balancer.port, "127.0.0.1");
  onTestFinished(() => void socket.destroy());
  socket.write("GET /a HTTP/1.1\r\nHost: a\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n\r\n");
  const [answer] = (await once(socket, "data")) as [Buffer];
  expect(answer.toString()).toMatch(/^HTTP\/1\.1 101 websocket at/);
});
