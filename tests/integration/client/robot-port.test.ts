/** The port of a client, with a robot at a real relay. */
import {
  RefusedError,
  scriptListSchema,
  type EndingState,
  type Snapshot,
} from "@corridor/protocol";
import { describe, expect, it, onTestFinished, vi } from "vitest";
import { openPort } from "../../../packages/client/src/client-port.ts";
import { HostConnection } from "../../../packages/client/src/host-connection.ts";
import { registerRobot } from "../../../packages/client/src/register-robot.ts";
import { RobotClient } from "../../../packages/client/src/robot-client.ts";
import {
  robotPortCases,
  type PortPage,
  type PortWorld,
} from "../../../packages/protocol/src/testing/robot-port.cases.ts";
import { snapshotOf } from "../../../packages/protocol/src/testing/index.ts";
import type { RelayProcess } from "../../support/relay-process.ts";
import { sharedRelayProcess, startRelayProcess } from "../../support/test-relay-process.ts";

/** A client reconnects within seconds after a restart. */
const WAIT = { timeout: 20_000 };

const maze = {
  format: "corridor/maze",
  version: 1,
  blocks: ["#####", "#...#", "#####"],
  start: { column: 1, row: 1, heading: "east" },
  goals: [{ column: 3, row: 1 }],
};

type Registration = Awaited<ReturnType<typeof registerRobot>>;

/** A page that runs no command, and ends what runs when another page takes over. */
async function pageAt(origin: string, credentials: Registration): Promise<PortPage> {
  let snapshot: Snapshot | null = null;
  const arrived: number[] = [];
  const cancelled: number[] = [];
  const running = new Set<number>();
  const connected = Promise.withResolvers<void>();
  const ended = (seq: number, state: EndingState): void => {
    running.delete(seq);
    connection.ended(seq, {
      state,
      reason: null,
      pose: { x: 150, y: 150, heading: 90 },
      distance: 50,
    });
  };
  const connection: HostConnection = new HostConnection({
    origin,
    credentials,
    lastApplied: 0,
    fresh: true,
    snapshot: () => snapshot,
    onCommand: ({ seq }) => void arrived.push(seq),
    onStop: ({ seq }) => void arrived.push(seq),
    onCancel: (seq) => void cancelled.push(seq),
    onGiveBack: () => undefined,
    onYield: () => {
      for (const seq of running) ended(seq, "cancelled");
    },
    onState: () => undefined,
    onRefused: () => undefined,
    onStatus: ({ kind }) => {
      if (kind === "connected") connected.resolve();
    },
    onDrivers: () => undefined,
  });
  onTestFinished(() => connection.close());
  await connected.promise;
  return {
    report: (change) => {
      snapshot = snapshotOf({ seq: (snapshot?.seq ?? 1) + 1, ...change });
      connection.sendSnapshot(snapshot);
    },
    arrived: () => arrived,
    cancelled: () => cancelled,
    started: (seq) => {
      running.add(seq);
      connection.started(seq);
    },
    ended,
  };
}

async function world(relay: RelayProcess): Promise<PortWorld> {
  const registration = await registerRobot(relay.url, fetch);
  const { id, ownerKey } = registration;
  const keys: string[] = [];
  const ask = async (method: string, path: string, body?: object) => {
    const headers = { Authorization: `Bearer ${ownerKey}`, "Content-Type": "application/json" };
    const init = { method, headers, ...(body !== undefined && { body: JSON.stringify(body) }) };
    const response = await fetch(`${relay.url}/api/v1/robots/${id}${path}`, init);
    if (!response.ok) throw new Error(await response.text());
    return response;
  };
  return {
    page: await pageAt(relay.url, registration),
    open: async (kind) => {
      const response = await ask("POST", "/keys", { kind });
      const made = (await response.json()) as { id: string; address: string };
      keys.push(made.id);
      const port = openPort(await RobotClient.connect(made.address, { answerTimeout: 2_000 }));
      onTestFinished(() => port.close());
      return port;
    },
    takeOver: async () => pageAt(relay.url, registration),
    publishMaze: async (name) => void (await ask("PUT", "/maze", { ...maze, name })),
    pause: async (isPaused) => void (await ask(isPaused ? "PUT" : "DELETE", "/pause")),
    block: async () => {
      const list = scriptListSchema.parse(await (await ask("GET", "/scripts")).json());
      for (const { driver, client, name } of list.scripts) {
        await ask("POST", "/blocked", { driver, client, name });
      }
    },
    revoke: async () => {
      for (const key of keys) await ask("DELETE", `/keys/${key}`);
    },
    remove: async () => void (await ask("DELETE", "")),
    pass: (ms) => new Promise((resolve) => setTimeout(resolve, ms)),
  };
}

const sharedRelay = sharedRelayProcess();
robotPortCases("the port of a client", async () => world(await sharedRelay()));

describe("the port of a client whose relay restarts", () => {
  it("receives a gap, and the end of its command", async () => {
    const relay = await startRelayProcess();
    const { page, open } = await world(relay);
    const port = await open("drive");
    const calls: string[] = [];
    port.subscribe({
      snapshot: () => undefined,
      state: ({ seq, state }) => void calls.push(`${seq} ${state}`),
      gap: (open) =>
        void calls.push(`gap ${open.map(({ seq, state }) => `${seq} ${state}`).join(", ")}`),
      maze: () => undefined,
      end: () => void calls.push("end"),
    });
    const { seq } = await port.send({ action: "move", distance: 100 });
    await vi.waitFor(() => expect(page.arrived()).toEqual([seq]));
    page.started(seq);
    await vi.waitFor(() => expect(calls).toContain("1 started"));
    const end = port.endOf(seq, 25_000);
    await relay.killAndRestart();
    await vi.waitFor(() => expect(calls).toContain("gap 1 started"), WAIT);
    page.ended(seq, "completed");
    expect(await end).toMatchObject({ seq, state: "completed" });
    expect(calls).not.toContain("end");
    expect((await port.send({ action: "stop" })).seq).toBe(seq + 1);
  });

  it("learns of a maze that opened while it was not connected", async () => {
    const relay = await startRelayProcess();
    const { open, publishMaze } = await world(relay);
    await publishMaze("First");
    const port = await open("watch");
    const mazes: string[] = [];
    const ignore = (): void => undefined;
    const maze = (version: string): void => void mazes.push(version);
    port.subscribe({ snapshot: ignore, state: ignore, gap: ignore, maze, end: ignore });
    const { version } = await port.readMaze();
    mazes.length = 0;
    await relay.killAndRestart();
    await publishMaze("Second");
    await vi.waitFor(() => expect(mazes).toHaveLength(1), WAIT);
    expect(mazes[0]).not.toBe(version);
    expect((await port.readMaze()).version).toBe(mazes[0]);
  });

  it("refuses when the relay does not return in time", async () => {
    const relay = await startRelayProcess();
    const { open } = await world(relay);
    const port = await open("drive");
    await relay.kill();
    await expect(port.send({ action: "stop" })).rejects.toMatchObject({
      problem: { type: "/problems/unreachable", status: 504 },
    });
    await expect(port.readMaze()).rejects.toBeInstanceOf(RefusedError);
  });
});
