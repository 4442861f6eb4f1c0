/** A relay in a process of its own, and a robot in a grid of blocks that is connected to it. */
import { onTestFinished } from "vitest";
import { registerRobot } from "../../../packages/client/src/register-robot.ts";
import { GridRobot } from "./grid-robot.ts";
import { startRelayProcess } from "../test-relay-process.ts";

export async function robotIn(maze: readonly string[]) {
  const relay = await startRelayProcess();
  const registration = await registerRobot(relay.url, fetch);
  const robot = new GridRobot(relay.url, registration, maze);
  onTestFinished(() => robot.link.close());
  return { relay, robot, registration };
}
