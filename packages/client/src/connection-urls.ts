import type { Transport } from "./transport-choice.ts";

/**
 * The URLs of the connections to a robot or a class. They do not contain the key.
 * @param origin of the service, such as https://robots.example.org
 */
export function connectionUrls(
  origin: string,
  kind: "robots" | "classes",
  id: string,
): Record<Transport, string> {
  const url = `${origin}/api/v1/${kind}/${id}`;
  return { websocket: `${url.replace(/^http/, "ws")}/socket`, "long-poll": `${url}/long-poll` };
}
