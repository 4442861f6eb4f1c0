/** Which clients have reached the robot. The service lists a silent script for two minutes only. */
import type { ListedScript } from "../../simulator/protocol/worker-messages.ts";

/**
 * Names of clients by robot, since this page opened. Not state of a component, because the panel closes
 * and opens.
 */
const connected = new Map<string, Set<string>>();

/** @returns the `client` of each script that has sent a message to the robot */
export function connectedClients(
  robot: string,
  scripts: readonly ListedScript[],
): ReadonlySet<string> {
  const clients = connected.get(robot) ?? new Set();
  connected.set(robot, clients);
  for (const { client } of scripts) clients.add(client);
  return clients;
}
