/** A robot in a grid of blocks that is connected to a relay in a process of its own. */
import { onTestFinished } from "vitest";
import { registerRobot } from "../../../packages/client/src/register-robot.ts";
import { GridRobot } from "./grid-robot.ts";
import type { RelayProcess } from "../relay-process.ts";
import { startRelayProcess } from "../test-relay-process.ts";

/** @param shared relay of other tests; default: one of this test, which it may restart */
export async function robotIn(maze: readonly string[], shared?: RelayProcess) {
  const relay = shared ?? (await startRelayProcess());
  const registration = await registerRobot(relay.url, fetch);
  const robot = new GridRobot(relay.url, registration, maze);
  onTestFinished(() => robot.connection.close());
  return { relay, robot, registration };
}
