/** A robot in a corridor with four corners at a relay, for agents. */
import type { MazeDocument } from "@corridor/maze";
import { onTestFinished } from "vitest";
import { registerRobot } from "../../../packages/client/src/register-robot.ts";
import { MazeHost } from "../client/maze-host.ts";

export const corridor: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "Corridor",
  blocks: ["#######", "#.....#", "#####.#", "#...#.#", "#.#...#", "#.#####", "#######"],
  start: { column: 1, row: 1, heading: "east" },
  goals: [{ column: 1, row: 5 }],
};

/**
 * @param relay where the robot is registered
 * @param pageOrigin relay to which its page connects
 */
export async function corridorHost<R extends { url: string }>(
  relay: R,
  maze = corridor,
  pageOrigin = relay.url,
) {
  const registration = await registerRobot(relay.url, fetch);
  const page = new MazeHost(pageOrigin, registration, maze);
  onTestFinished(() => page.connection.close());
  await page.connected;
  await MazeHost.publish(relay.url, registration, maze);
  return { relay, registration, page, url: `${relay.url}/r/${registration.id}/mcp` };
}
