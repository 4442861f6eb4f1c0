/** What the texts contain of a robot: its keys may be masked, or all parts be placeholders. */
export interface RobotParts {
  /** the service, such as `https://HOST`, without a trailing slash */
  origin: string;
  id: string;
  /** the key in the robot's address */
  key: string;
  /** a key that a URL may contain */
  urlKey: string;
}

/** The robot's address, which is all that a script needs. */
export function addressOf({ origin, id, key }: RobotParts): string {
  return `${origin}/r/${id}#${key}`;
}

/** Base URL of the robot's REST API. */
export function apiOf({ origin, id }: RobotParts): string {
  return `${origin}/api/v1/robots/${id}`;
}

/** URL for clients of rosbridge, without a key. */
export function rosUrlOf({ origin, id }: RobotParts): string {
  return `${origin.replace(/^http/, "ws")}/r/${id}/ros`;
}

/** URL for clients of the Model Context Protocol, without a key. */
export function mcpUrlOf({ origin, id }: RobotParts): string {
  return `${origin}/r/${id}/mcp`;
}

/** URL of the SOAP service. */
export function soapUrlOf({ origin }: RobotParts): string {
  return `${origin}/soap`;
}
