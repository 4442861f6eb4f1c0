import { connect, createServer, type AddressInfo, type Socket } from "node:net";
import { expect, it, onTestFinished } from "vitest";
import { Dice } from "../../../apps/relay/src/testing/faults/dice.ts";
import { sleep, until } from "../clock.ts";
import { FaultProxy } from "./fault-proxy.ts";

/** A server that sends back what it gets, behind a net that breaks. */
async function echoBehindProxy() {
  const atServer: Socket[] = [];
  const server = createServer((socket) => {
    atServer.push(socket);
    socket.on("error", () => undefined);
    socket.pipe(socket);
  });
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  const { port } = server.address() as AddressInfo;
  const proxy = await FaultProxy.start({ target: () => port, dice: new Dice(1) });
  onTestFinished(async () => {
    await proxy.close();
    for (const socket of atServer) socket.destroy();
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
  return { proxy, atServer, dial };
}

const LONG_MS = 10_000;

it("lets everything through while nothing is broken, the end too", async () => {
  const { dial, proxy } = await echoBehindProxy();
  const client = dial();
  client.socket.end("hello");
  await until(() => client.isClosed, LONG_MS);
  expect(client.text).toBe("hello");
  await until(() => proxy.connections === 0, LONG_MS);
  expect(proxy.connections).toBe(0);
});

it("slices and delays, and keeps the order", async () => {
  const { dial, proxy } = await echoBehindProxy();
  proxy.isSlicing = true;
  proxy.delay = { least: 0, most: 3 };
  const text = Array.from({ length: 500 }, (_none, n) => `${n};`).join("");
  const client = dial();
  client.socket.end(text);
  await until(() => client.isClosed, LONG_MS);
  expect(client.text).toBe(text);
});

it("delays one direction and not the other", async () => {
  const { dial, proxy, atServer } = await echoBehindProxy();
  proxy.delays.down = { least: 600, most: 600 };
  const client = dial();
  client.socket.write("hello");
  await until(() => (atServer[0]?.bytesRead ?? 0) === 5, LONG_MS);
  expect(client.text).toBe("");
  await until(() => client.text === "hello", LONG_MS);
  expect(client.text).toBe("hello");
});

it("holds up what is said, and loses nothing of it", async () => {
  const { dial, proxy } = await echoBehindProxy();
  const client = dial();
  proxy.hold(200);
  client.socket.write("late");
  await sleep(50);
  expect(client.text).toBe("");
  await until(() => client.text === "late", LONG_MS);
  expect(client.text).toBe("late");
});

it("cuts both sides, and refuses new connections while the net is away", async () => {
  const { atServer, dial, proxy } = await echoBehindProxy();
  const client = dial();
  client.socket.write("x");
  await until(() => client.text === "x", LONG_MS);
  expect(proxy.breakFor(300)).toBe(1);
  await until(() => client.isClosed && atServer[0]?.destroyed === true, LONG_MS);
  expect(client.isClosed).toBe(true);
  const refused = dial();
  await until(() => refused.isClosed, LONG_MS);
  expect(atServer.length).toBe(1);
  await until(() => proxy.isUp, LONG_MS);
  const again = dial();
  again.socket.write("back");
  await until(() => again.text === "back", LONG_MS);
  expect(again.text).toBe("back");
  expect(proxy.cuts).toBe(1);
});

it.each(["client", "relay"] as const)(
  "leaves a connection half open whose %s is gone, until it breaks",
  async (gone) => {
    const { atServer, dial, proxy } = await echoBehindProxy();
    const client = dial();
    client.socket.write("x");
    await until(() => client.text === "x", LONG_MS);
    expect(proxy.halfOpen(gone, 400)).toBe(1);
    const ends = { client: client.socket, relay: atServer[0] };
    await until(() => ends[gone]?.destroyed === true, LONG_MS);
    const other = gone === "client" ? ends.relay : ends.client;
    expect(other?.destroyed).toBe(false);
    other?.write("nobody hears this");
    await until(() => other?.destroyed === true, LONG_MS);
    expect(other?.destroyed).toBe(true);
    expect(client.text).toBe("x");
  },
);
