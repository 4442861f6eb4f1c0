import { once } from "node:events";
import { createServer, type Server } from "node:http";
import { connect, type AddressInfo } from "node:net";
import { expect, it, onTestFinished } from "vitest";
import { startBalancer } from "./balancer.ts";

/** Starts relays that answer each request with their own port and the request body. */
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
  const send = async (path: string, body?: string): Promise<{ port: number; body: string }> => {
    const url = `http://127.0.0.1:${balancer.port}/api/v1/${path}`;
    const init = body === undefined ? {} : { method: "POST", body };
    return (await (await fetch(url, init)).json()) as { port: number; body: string };
  };
  const portsOf = async (paths: string[]): Promise<Set<number>> => {
    const ports = new Set<number>();
    for (const path of paths) ports.add((await send(path)).port);
    return ports;
  };
  return { relays, balancer, send, portsOf };
}

it("sends all requests of a robot's long-poll connection to one relay", async () => {
  const { send, portsOf } = await withRelays(3);
  const ports = new Set<number>();
  for (let n = 0; n < 6; n++) {
    ports.add((await send("robots/1/long-poll/messages?after=0&wait=1")).port);
    ports.add((await send("robots/1/long-poll", '{"type":"hello"}')).port);
    await send("robots/1/commands");
  }
  expect(ports.size).toBe(1);
  const others = Array.from({ length: 30 }, (_none, n) => `robots/${n}/long-poll`);
  expect((await portsOf(others)).size).toBe(3);
});

it("sends all requests of the long-poll connections of a class to one relay", async () => {
  const { portsOf } = await withRelays(3);
  const paths = ["", "/messages?after=0", ""].map((path) => `classes/1/long-poll${path}`);
  expect((await portsOf(paths)).size).toBe(1);
  expect((await portsOf(Array.from({ length: 3 }, () => "classes/1/lesson"))).size).toBe(3);
});

it("distributes other requests round-robin, with their bodies", async () => {
  const { send, portsOf } = await withRelays(2);
  expect((await portsOf(["robots/a/commands", "robots/a/commands"])).size).toBe(2);
  expect(await send("robots/a/commands", '{"action":"stop"}')).toMatchObject({
    body: '{"action":"stop"}',
  });
});

it("skips a closed relay and leaves the long-poll connections of the others in place", async () => {
  const { relays, send } = await withRelays(3);
  const paths = Array.from({ length: 20 }, (_none, n) => `robots/${n}/long-poll`);
  const before = await Promise.all(paths.map(async (path) => (await send(path)).port));
  const closedPort = before[0] ?? 0;
  relays.get(closedPort)?.close();
  relays.get(closedPort)?.closeAllConnections();
  const after = await Promise.all(paths.map(async (path) => (await send(path)).port));
  expect(after).not.toContain(closedPort);
  const unmoved = paths.map((_path, n) => before[n] === closedPort || before[n] === after[n]);
  expect(unmoved).not.toContain(false);
});

it("disconnects a client when the relay disconnects before it answers", async () => {
  const { relays, send } = await withRelays(1);
  const [relay] = relays.values();
  relay?.removeAllListeners("request").on("request", (request) => void request.socket.destroy());
  await expect(send("robots/a/long-poll/messages?after=0&wait=25")).rejects.toThrow(/fetch failed/);
});

it("ends a request at the relay when the client disconnects", async () => {
  const { balancer, relays } = await withRelays(1);
  const [relay] = relays.values();
  const ended = new Promise<string>((resolve) => {
    relay?.removeAllListeners("request").on("request", ({ url }, response) => {
      response.on("close", () => resolve(url ?? "")).write("first part");
    });
  });
  const answer = await fetch(`http://127.0.0.1:${balancer.port}/api/v1/robots/a/events`);
  const reader = answer.body?.getReader();
  await reader?.read();
  await reader?.cancel();
  expect(await ended).toBe("/api/v1/robots/a/events");
});

it("proxies an upgrade request to a relay", async () => {
  const { balancer } = await withRelays(1);
  const socket = connect(balancer.port, "127.0.0.1");
  onTestFinished(() => void socket.destroy());
  socket.write("GET /a HTTP/1.1\r\nHost: a\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n\r\n");
  const [answer] = (await once(socket, "data")) as [Buffer];
  expect(answer.toString()).toMatch(/^HTTP\/1\.1 101 websocket at/);
});
