/** `corridor viple` in its own process, with a robot at a real relay. */
import { once } from "node:events";
import type { AddressInfo } from "node:net";
import { scriptListSchema } from "@corridor/protocol";
import { describe, expect, it, onTestFinished } from "vitest";
import { WebSocketServer, type WebSocket } from "ws";
import { sleep } from "../../../../e2e/faults/clock.ts";
import { memoryMib } from "../../../../e2e/faults/memory.ts";
import { BridgeProcess } from "../../../support/bridges/bridge-process.ts";
import { corridorHost } from "../../../support/mcp/corridor-host.ts";
import { sharedRelayProcess } from "../../../support/test-relay-process.ts";
import { VipleClient } from "../../../support/viple/viple-client.ts";

const POLL = { timeout: 10_000 };
const FLOOD_MS = 2_000;
/** Garbage takes up to 100 MiB. A flood sends some GB, of which a buffer would contain more. */
const MAX_MIB = 256;
const AHEAD = { servos: [{ servoId: -1, servoSpeed: 0.5 }] };
const RIGHT = { servos: [{ servoSpeed: 90, isTurn: true }] };
/** The first readings of the robot at its start, with the default options. */
const FIRST =
  '{"sensors":[{"name":"touch","id":0,"value":0},{"name":"distance","id":1,"value":50},{"name":"distance","id":2,"value":450}]}';

const sharedRelay = sharedRelayProcess();

async function robot() {
  const host = await corridorHost(await sharedRelay());
  const { id, driverKey } = host.registration;
  return { ...host, address: `${host.relay.url}/r/${id}#${driverKey}` };
}

async function bridged(...options: string[]) {
  const host = await robot();
  return { ...host, ...(await BridgeProcess.startViple(host.address, ...options)) };
}

describe("corridor viple", () => {
  it("listens as the Unity simulator and as a physical robot, and the owner sees VIPLE", async () => {
    const { simulatorPort, robotPort, page, relay, registration } = await bridged();
    const simulator = await VipleClient.open(simulatorPort);
    const physical = await VipleClient.open(robotPort, "\r\n");
    await expect.poll(() => simulator.received, POLL).toContain(`${FIRST}\n${FIRST}\n`);
    await expect.poll(() => physical.received, POLL).toContain(`${FIRST}\r\n${FIRST}\r\n`);
    physical.send(RIGHT);
    await expect.poll(() => page.robot.done, POLL).toMatchObject([{ action: "turn", degrees: 90 }]);
    simulator.send({ servos: [{ servoId: 5, servoSpeed: 0.25 }] });
    await expect
      .poll(() => page.robot.done.at(-1), POLL)
      .toMatchObject({ action: "drive", left: 0, right: 0.25 });
    const answer = await fetch(`${relay.url}/api/v1/robots/${registration.id}/scripts`, {
      headers: { Authorization: `Bearer ${registration.ownerKey}` },
    });
    const { scripts } = scriptListSchema.parse(await answer.json());
    expect(scripts).toMatchObject([{ client: "VIPLE", name: null, connections: 1 }]);
  });

  it("sends the sensors of the options", async () => {
    const options = ["--sensor", "left=4", "--sensor", "front=sound:1", "--unit", "mm"];
    const { simulatorPort } = await bridged(...options);
    const client = await VipleClient.open(simulatorPort);
    const expected =
      '{"sensors":[{"name":"distance","id":4,"value":500},{"name":"sound","id":1,"value":4500}]}\n';
    await expect.poll(() => client.received, POLL).toContain(expected);
  });

  it("stops a motion when VIPLE disconnects, and on Ctrl+C", async () => {
    const { simulatorPort, page, bridge } = await bridged();
    page.endsCommands = false;
    const first = await VipleClient.open(simulatorPort);
    first.send(AHEAD);
    await expect.poll(() => page.running, POLL).toBeGreaterThan(0);
    first.socket.destroy();
    await expect.poll(() => page.running, POLL).toBe(0);
    const second = await VipleClient.open(simulatorPort);
    second.send(RIGHT);
    await expect.poll(() => page.running, POLL).toBe(1);
    bridge.signal("SIGINT");
    expect(await bridge.exited).toBe(0);
    expect(page.running).toBe(0);
  });

  it.each([
    { name: "malformed JSON", bad: '{"servos":[', says: "is not one JSON object" },
    { name: "a list", bad: "[]", says: "is not one JSON object" },
    { name: "NaN", bad: '{"servos":[{"servoSpeed":NaN}]}', says: "is not one JSON object" },
    { name: "a speed as text", bad: '{"servos":[{"servoSpeed":"1"}]}', says: "expected a number" },
    { name: "256 levels", bad: "[".repeat(256) + "]".repeat(256), says: "is not one JSON object" },
    { name: "a field __proto__", bad: '{"__proto__":{},"servos":1}', says: "expected a list" },
    { name: "bytes that are no UTF-8", bad: "\xff\xfe\0", says: "is not one JSON object" },
    { name: "16 KiB and a byte", bad: "x".repeat(16 * 1024 + 1), says: "has more than 16 KiB" },
  ])("prints one line for $name, and serves on", async ({ bad, says }) => {
    const { simulatorPort, page, bridge } = await bridged();
    const other = await VipleClient.open(simulatorPort);
    const client = await VipleClient.open(simulatorPort);
    const started = bridge.output.stderr;
    client.socket.write(bad, "latin1");
    client.send("");
    client.send(RIGHT);
    await expect.poll(() => page.robot.done, POLL).toMatchObject([{ action: "turn", degrees: 90 }]);
    other.send(RIGHT);
    await expect.poll(() => page.robot.done, POLL).toHaveLength(2);
    expect(bridge.output.stderr.slice(started.length)).toMatch(
      new RegExp(`^A (message|line) of VIPLE [^\n]*${says}[^\n]*\n$`),
    );
  });

  it.each([
    { name: "lines", lines: `${JSON.stringify(RIGHT)}\n`.repeat(1_000) },
    { name: "bytes without a line end", lines: "x".repeat(64 * 1024) },
  ])("serves others while a client floods it with $name", async ({ lines }) => {
    const { simulatorPort, page, bridge } = await bridged();
    const before = memoryMib(bridge.pid);
    const flood = await VipleClient.open(simulatorPort);
    const more = (): void => {
      while (flood.socket.write(lines));
    };
    flood.socket.on("drain", more);
    more();
    const other = await VipleClient.open(simulatorPort);
    await expect.poll(() => other.received, POLL).toContain(FIRST.slice(0, 40));
    other.send({ servos: [{ servoSpeed: -0.5 }] });
    await expect
      .poll(() => page.robot.done.some(({ action }) => action === "drive"), POLL)
      .toBe(true);
    await sleep(FLOOD_MS);
    expect(memoryMib(bridge.pid) - before).toBeLessThan(MAX_MIB);
    flood.socket.destroy();
    bridge.signal("SIGINT");
    expect(await bridge.exited).toBe(0);
  });

  it("disconnects a page", async () => {
    const { robotPort, page, bridge } = await bridged();
    const request = fetch(`http://127.0.0.1:${robotPort}/`, {
      method: "POST",
      body: `\n${JSON.stringify(RIGHT)}\n`,
    });
    await expect(request).rejects.toThrow("fetch failed");
    await bridge.says(/A page or another HTTP client connected\. It was disconnected\./);
    expect(page.robot.done).toEqual([]);
  });

  it("prints no key, and exits when the key is revoked", async () => {
    const { address, registration, relay, bridge, simulatorPort } = await bridged();
    const second = BridgeProcess.launch([
      "viple",
      address,
      "--simulator-port",
      String(simulatorPort),
    ]);
    expect(await second.exited).toBe(1);
    expect(second.output.stderr).toMatch(/^Port \d+ is in use\. .* --simulator-port\.\n$/);
    const client = await VipleClient.open(simulatorPort);
    await fetch(`${relay.url}/api/v1/robots/${registration.id}/keys`, {
      method: "POST",
      headers: {
        Authorization: `Bearer ${registration.ownerKey}`,
        "Content-Type": "application/json",
      },
      body: JSON.stringify({ kind: "drive", replace: true }),
    });
    expect(await bridge.exited).toBe(1);
    expect(bridge.output.stderr).toContain("The key is invalid or was revoked.");
    await expect.poll(() => client.socket.closed, POLL).toBe(true);
    for (const { output } of [bridge, second]) {
      expect(JSON.stringify(output)).not.toContain(registration.driverKey.slice(4));
    }
  });

  it.each([
    { args: ["--sensor", "top=1"], says: '--sensor: found "top=1", expected a side' },
    { args: ["--unit", "mile"], says: '--unit: found "mile", expected one of mm, cm, inch, m' },
    { args: ["--connect", "http://localhost"], says: "--connect: found" },
    { args: ["--robot-port", "x"], says: '--robot-port: found "x", expected a number' },
  ])("refuses the options $args", async ({ args, says }) => {
    const address = `http://localhost/r/${"a".repeat(22)}#drv_${"b".repeat(22)}`;
    const bridge = BridgeProcess.launch(["viple", address, ...args]);
    expect(await bridge.exited).toBe(2);
    expect(bridge.output.stderr).toContain(says);
  });
});

describe("corridor viple --connect", () => {
  /** VIPLE's server on a port; 0: any free one. */
  async function startServer(port = 0) {
    const server = new WebSocketServer({ port, host: "127.0.0.1" });
    const stop = (): void => {
      for (const client of server.clients) client.terminate();
      server.close();
    };
    onTestFinished(stop);
    await once(server, "listening");
    const connected = once(server, "connection").then(([socket]) => socket as WebSocket);
    return { port: (server.address() as AddressInfo).port, connected, stop };
  }

  it("connects when VIPLE starts, and again when VIPLE restarts", { timeout: 60_000 }, async () => {
    const { address, page } = await robot();
    const { port, stop } = await startServer();
    stop();
    const url = `ws://127.0.0.1:${port}`;
    const bridge = BridgeProcess.launch(["viple", "--connect", url], { CORRIDOR_ROBOT: address });
    await bridge.says(/^VIPLE at 127\.0\.0\.1:\d+ is not connected: .*ECONNREFUSED.*\. Retrying\./);
    const first = await startServer(port);
    const socket = await first.connected;
    const [readings] = (await once(socket, "message")) as [Buffer];
    expect(readings.toString()).toBe(FIRST);
    socket.send(JSON.stringify(RIGHT));
    await expect.poll(() => page.robot.done, POLL).toMatchObject([{ action: "turn", degrees: 90 }]);
    first.stop();
    const second = await startServer(port);
    (await second.connected).send(JSON.stringify(RIGHT));
    await expect.poll(() => page.robot.done, POLL).toHaveLength(2);
    expect(bridge.output.stderr.match(/Retrying/g)).toHaveLength(2);
    bridge.signal("SIGTERM");
    expect(await bridge.exited).toBe(0);
  });

  it("connects again after a message of more than 16 KiB", { timeout: 60_000 }, async () => {
    const { address, page } = await robot();
    const { port, connected } = await startServer();
    const url = `ws://127.0.0.1:${port}`;
    const bridge = BridgeProcess.launch(["viple", "--connect", url], { CORRIDOR_ROBOT: address });
    const socket = await connected;
    socket.send(`{"a":"${"x".repeat(16 * 1024)}"}`);
    expect((await once(socket, "close"))[0]).toBe(1009);
    await bridge.says(/Max payload size exceeded\. Retrying\.\nConnected to VIPLE/);
    expect(page.robot.done).toEqual([]);
  });
});
