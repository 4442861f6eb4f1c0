/**
 * Runs a relay and a grid robot, for tests in other languages.
 *
 *     node robot-process.ts ROWS
 *
 * ROWS is the maze as JSON, a list of strings. The first line on standard output is
 * `{"address","origin","openCells","ownerKey"}`. Each line on standard input is an instruction, and
 * results in one line of output. The process exits at the end of its standard input.
 *
 * - `kill`, `start`: kills and restarts the relay
 * - `disconnect`, `connect`: the robot's page
 * - `state`: what the robot has done
 */
import { createInterface } from "node:readline";
import { setTimeout } from "node:timers/promises";
import { registerRobot } from "../../../packages/client/src/register-robot.ts";
import { GridRobot } from "./grid-robot.ts";
import { RelayProcess } from "../relay-process.ts";

const rows = JSON.parse(process.argv[2] ?? "[]") as string[];
const relay = await RelayProcess.start();
const origin = relay.url;
const registration = await registerRobot(origin, fetch);
const robot = new GridRobot(origin, registration, rows);

const instructions: Record<string, () => unknown> = {
  kill: () => relay.kill(),
  start: () => relay.restart(),
  disconnect: async () => {
    robot.connection.close();
    await untilGone();
  },
  connect: () => robot.connection.open(),
  state: () => ({
    done: robot.done,
    visited: robot.visited.size,
    pose: robot.snapshot().pose,
    bumps: robot.snapshot().bumps,
  }),
};

/** Waits until the relay has noticed that the page is gone. */
async function untilGone(): Promise<void> {
  const headers = { authorization: `Bearer ${registration.ownerKey}` };
  for (;;) {
    const response = await fetch(`${origin}/api/v1/robots/${registration.id}`, { headers });
    const { snapshot } = (await response.json()) as { snapshot: { state: string } | null };
    if (snapshot === null || snapshot.state === "gone") return;
    await setTimeout(10);
  }
}

function print(value: unknown): void {
  process.stdout.write(`${JSON.stringify(value)}\n`);
}

const { address, ownerKey } = registration;
print({ address, origin, openCells: robot.openCells, ownerKey });
for await (const instruction of createInterface({ input: process.stdin })) {
  print((await instructions[instruction]?.()) ?? null);
}
robot.connection.close();
await relay.kill();
await relay.stop();
process.exit();
