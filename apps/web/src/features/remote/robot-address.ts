/** The parts of a robot's address, `https://HOST/r/ID#KEY`, and the key as it may be seen by others. */
import type { RemoteSession } from "../../worker/worker-messages.ts";

export interface RobotAddress {
  /** with the key: all that a script needs */
  full: string;
  /** what the page displays: the URL without its key */
  shown: string;
  /** where the robot's REST calls begin */
  api: string;
  key: string;
}

/** How much of a key may be seen, so that two can be told apart. */
const SHOWN_KEY_LENGTH = 4;

/** @returns null for an address that is not a URL */
export function robotAddress({ id, address, driverKey }: RemoteSession): RobotAddress | null {
  const url = URL.parse(address);
  if (url === null) return null;
  return {
    full: address,
    shown: url.origin + url.pathname,
    api: `${url.origin}/api/v1/robots/${id}`,
    key: driverKey,
  };
}

/** The key with all but its last four characters hidden; a short key is hidden altogether. */
export function maskKey(key: string): string {
  const tail = key.length >= 3 * SHOWN_KEY_LENGTH ? key.slice(-SHOWN_KEY_LENGTH) : "••••";
  return `•••• •••• ${tail}`;
}
