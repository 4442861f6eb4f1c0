/** A scripted peer of VIPLE follows the right wall with `corridor viple`, in both connection modes. */
import { once } from "node:events";
import type { AddressInfo } from "node:net";
import type { MazeDocument } from "@corridor/maze";
import type { Registration, Snapshot } from "@corridor/protocol";
import { describe, expect, it, onTestFinished } from "vitest";
import { WebSocketServer } from "ws";
import { registerRobot } from "../../../../packages/client/src/register-robot.ts";
import { BridgeProcess } from "../../../support/bridges/bridge-process.ts";
import { openSimulatedPage } from "../../../support/client/simulated-page.ts";
import { sharedRelayProcess } from "../../../support/test-relay-process.ts";
import { VipleClient } from "../../../support/viple/viple-client.ts";
import { WallFollower } from "../../../support/viple/wall-follower.ts";

const TIMEOUT_MS = 180_000;
const POLL = { timeout: 150_000, interval: 250 };

/** With turns to both sides, and a dead end. */
const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "Right wall",
  blocks: ["...#.", ".#.#.", ".#...", ".#.##", ".#..."],
  start: { column: 0, row: 4, heading: "north" },
  goals: [{ column: 4, row: 0 }],
};
/** To the goal. The fifth turn to the left is at the wall behind it. */
const TURNS = { left: 5, right: 4 };

const sharedRelay = sharedRelayProcess();

async function robotInMaze() {
  const relay = await sharedRelay();
  const registration = await registerRobot(relay.url, fetch);
  const page = openSimulatedPage(relay.url, registration, maze);
  await expect.poll(() => page.isConnected, POLL).toBe(true);
  const address = `${relay.url}/r/${registration.id}#${registration.driverKey}`;
  return { registration, url: relay.url, address };
}

async function snapshotOf({ url, registration }: { url: string; registration: Registration }) {
  const answer = await fetch(`${url}/api/v1/robots/${registration.id}/sensors`, {
    headers: { Authorization: `Bearer ${registration.driverKey}` },
  });
  return (await answer.json()) as Snapshot;
}

describe("a diagram of VIPLE that follows the right wall", () => {
  it("reaches the goal when it connects to the robot", { timeout: TIMEOUT_MS }, async () => {
    const robot = await robotInMaze();
    const { simulatorPort } = await BridgeProcess.startViple(robot.address);
    const client = await VipleClient.open(simulatorPort);
    const diagram = new WallFollower((message) => client.send(message));
    client.onLine = (line) => diagram.receive(line);
    await expect.poll(() => diagram.turns.left, POLL).toBe(TURNS.left);
    expect(diagram.turns).toEqual(TURNS);
    expect(await snapshotOf(robot)).toMatchObject({ goalReached: true, bumps: 0 });
  });

  it("reaches the goal when the robot connects to VIPLE", { timeout: TIMEOUT_MS }, async () => {
    const robot = await robotInMaze();
    const viple = new WebSocketServer({ port: 0, host: "127.0.0.1" });
    onTestFinished(() => {
      for (const client of viple.clients) client.terminate();
      viple.close();
    });
    await once(viple, "listening");
    const turns: WallFollower["turns"][] = [];
    viple.on("connection", (socket) => {
      const diagram = new WallFollower((message) => socket.send(JSON.stringify(message)));
      turns.push(diagram.turns);
      socket.on("message", (data: Buffer) => diagram.receive(data.toString()));
    });
    const { port } = viple.address() as AddressInfo;
    const connect = `ws://127.0.0.1:${port}`;
    BridgeProcess.launch(["viple", "--connect", connect], { CORRIDOR_ROBOT: robot.address });
    await expect.poll(() => turns[0]?.left, POLL).toBe(TURNS.left);
    expect(turns).toEqual([TURNS]);
    expect(await snapshotOf(robot)).toMatchObject({ goalReached: true, bumps: 0 });
  });
});
