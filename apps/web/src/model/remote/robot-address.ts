/** The parts of a robot's address, `https://HOST/r/ID#KEY`, and a masked key. */
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";

export interface RobotAddress {
  /** the address with the key, which is all that a script needs */
  full: string;
  /** the displayed address, without the key */
  shown: string;
  /** base URL of the robot's REST API */
  api: string;
  key: string;
}

/** Number of displayed characters of a key, so that two keys can be distinguished. */
const SHOWN_KEY_LENGTH = 4;

/** @returns null if the address is not a URL */
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

/** The key with all but its last four characters masked. A short key is masked entirely. */
export function maskKey(key: string): string {
  const tail = key.length >= 3 * SHOWN_KEY_LENGTH ? key.slice(-SHOWN_KEY_LENGTH) : "••••";
  return `•••• •••• ${tail}`;
}
