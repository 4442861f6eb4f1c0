import { connect, createServer, type AddressInfo, type Socket } from "node:net";
import { expect, it, onTestFinished } from "vitest";
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import { sleep, waitUntil } from "../clock.ts";
import { FaultProxy } from "./fault-proxy.ts";

/** An echo server behind a proxy that injects faults. */
async function echoBehindProxy() {
  const serverSockets: Socket[] = [];
  const server = createServer((socket) => {
    serverSockets.push(socket);
    socket.on("error", () => undefined);
    socket.pipe(socket);
  });
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  const { port } = server.address() as AddressInfo;
  const proxy = await FaultProxy.start({ target: () => port, random: new SeededRandom(1) });
  onTestFinished(async () => {
    await proxy.close();
    for (const socket of serverSockets) socket.destroy();
    server.close();
  });
  const dial = () => {
    const socket = connect(Number(new URL(proxy.origin).port), "127.0.0.1");
    const client = { socket, text: "", isClosed: false };
    socket.on("data", (data) => (client.text += data.toString()));
    socket.on("error", () => undefined);
    socket.on("close", () => (client.isClosed = true));
    return client;
  };
  return { proxy, serverSockets, dial };
}

const LONG_MS = 10_000;

it("passes all data and the end of a stream without faults", async () => {
  const { dial, proxy } = await echoBehindProxy();
  const client = dial();
  client.socket.end("hello");
  await waitUntil(() => client.isClosed, LONG_MS);
  expect(client.text).toBe("hello");
  await waitUntil(() => proxy.connections === 0, LONG_MS);
  expect(proxy.connections).toBe(0);
});

it("keeps the order of sliced and delayed data", async () => {
  const { dial, proxy } = await echoBehindProxy();
  proxy.isSlicing = true;
  proxy.delay = { min: 0, max: 3 };
  const text = Array.from({ length: 500 }, (_none, n) => `${n};`).join("");
  const client = dial();
  client.socket.end(text);
  await waitUntil(() => client.isClosed, LONG_MS);
  expect(client.text).toBe(text);
});

it("delays one direction and not the other", async () => {
  const { dial, proxy, serverSockets } = await echoBehindProxy();
  proxy.delays.down = { min: 600, max: 600 };
  const client = dial();
  client.socket.write("hello");
  await waitUntil(() => (serverSockets[0]?.bytesRead ?? 0) === 5, LONG_MS);
  expect(client.text).toBe("");
  await waitUntil(() => client.text === "hello", LONG_MS);
  expect(client.text).toBe("hello");
});

it("stalls data without losing any", async () => {
  const { dial, proxy } = await echoBehindProxy();
  const client = dial();
  proxy.stall(200);
  client.socket.write("late");
  await sleep(50);
  expect(client.text).toBe("");
  await waitUntil(() => client.text === "late", LONG_MS);
  expect(client.text).toBe("late");
});

it("cuts both sides, and refuses new connections during an outage", async () => {
  const { serverSockets, dial, proxy } = await echoBehindProxy();
  const client = dial();
  client.socket.write("x");
  await waitUntil(() => client.text === "x", LONG_MS);
  expect(proxy.breakFor(300)).toBe(1);
  await waitUntil(() => client.isClosed && serverSockets[0]?.destroyed === true, LONG_MS);
  expect(client.isClosed).toBe(true);
  const refused = dial();
  await waitUntil(() => refused.isClosed, LONG_MS);
  expect(serverSockets.length).toBe(1);
  await waitUntil(() => proxy.isUp, LONG_MS);
  const again = dial();
  again.socket.write("back");
  await waitUntil(() => again.text === "back", LONG_MS);
  expect(again.text).toBe("back");
  expect(proxy.cuts).toBe(1);
});

it.each(["client", "relay"] as const)(
  "leaves a connection half open after its %s disconnects, until it breaks",
  async (side) => {
    const { serverSockets, dial, proxy } = await echoBehindProxy();
    const client = dial();
    client.socket.write("x");
    await waitUntil(() => client.text === "x", LONG_MS);
    expect(proxy.halfOpen(side, 400)).toBe(1);
    const ends = { client: client.socket, relay: serverSockets[0] };
    await waitUntil(() => ends[side]?.destroyed === true, LONG_MS);
    const other = side === "client" ? ends.relay : ends.client;
    expect(other?.destroyed).toBe(false);
    other?.write("never received");
    await waitUntil(() => other?.destroyed === true, LONG_MS);
    expect(other?.destroyed).toBe(true);
    expect(client.text).toBe("x");
  },
);
