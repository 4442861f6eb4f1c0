/**
 * A relay and a robot on a grid for tests that are not written in TypeScript.
 *
 *     node robot-process.ts ROWS
 *
 * ROWS is the maze as JSON, a list of strings. The first line on standard output is
 * `{"address","origin","openCells","ownerKey"}`. Each line on standard input is a word, answered by one line:
 * `kill` (the relay, without a goodbye), `start` (it again), `leave` and `come` (the robot's page),
 * `state` (what the robot has done). It ends with its standard input.
 */
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { setTimeout } from "node:timers/promises";
import { registerRobot } from "../register-robot.ts";
import { GridRobot } from "./grid-robot.ts";
import { killRelay, startRelayChild } from "./relay-child.ts";

const rows = JSON.parse(process.argv[2] ?? "[]") as string[];
const dataDir = mkdtempSync(join(tmpdir(), "corridor-"));
let { child, port } = await startRelayChild(dataDir, 0);
const origin = `http://127.0.0.1:${port}`;
const registration = await registerRobot(origin, fetch);
const robot = new GridRobot(origin, registration, rows);

const words: Record<string, () => unknown> = {
  kill: async () => killRelay(child),
  start: async () => {
    ({ child, port } = await startRelayChild(dataDir, port));
  },
  leave: async () => {
    robot.link.close();
    await untilGone();
  },
  come: () => robot.link.open(),
  state: () => ({
    done: robot.done,
    visited: robot.visited.size,
    pose: robot.snapshot().pose,
    bumps: robot.snapshot().bumps,
  }),
};

/** The relay hears a moment later that the page has gone; until then it says rightly that it is there. */
async function untilGone(): Promise<void> {
  const headers = { authorization: `Bearer ${registration.ownerKey}` };
  for (;;) {
    const answer = await fetch(`${origin}/api/v1/robots/${registration.id}`, { headers });
    const { snapshot } = (await answer.json()) as { snapshot: { state: string } | null };
    if (snapshot === null || snapshot.state === "gone") return;
    await setTimeout(10);
  }
}

function say(answer: unknown): void {
  process.stdout.write(`${JSON.stringify(answer)}\n`);
}

const { address, ownerKey } = registration;
say({ address, origin, openCells: robot.openCells, ownerKey });
for await (const word of createInterface({ input: process.stdin })) {
  say((await words[word]?.()) ?? null);
}
robot.link.close();
await killRelay(child);
rmSync(dataDir, { recursive: true, force: true });
process.exit();
