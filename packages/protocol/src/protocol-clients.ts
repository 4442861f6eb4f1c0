/**
 * Programs that drive a robot by another protocol, as the list of scripts names them in `client`. A
 * gateway knows its protocol; a bridge states it in the header `User-Agent`.
 */
export const protocolClients = {
  ros: "ROS",
  mcp: "MCP",
  soap: "SOAP",
  mms: "mms",
  viple: "VIPLE",
} as const;

export type ClientProtocol = keyof typeof protocolClients;

/** `User-Agent` of a bridge, such as `corridor-ros/0.1.0`. */
export function bridgeAgent(protocol: ClientProtocol, version: string): string {
  return `${bridgePrefix(protocol)}${version}`;
}

/** The first part of a bridge's `User-Agent`, before its version. */
export function bridgePrefix(protocol: string): string {
  return `corridor-${protocol}/`;
}
