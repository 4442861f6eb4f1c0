/** The address of a robot, `https://HOST/r/ID#KEY`: everything that a script needs. */
import { ClientError } from "./client-error.ts";

export interface RobotAddress {
  /** such as https://robots.example.org */
  origin: string;
  id: string;
  key: string;
}

const MAX_LENGTH = 400;
const ADDRESS = /^(https?:\/\/[^/?#\s]+)\/r\/([A-Za-z0-9_-]{22})#([A-Za-z0-9_-]{8,64})$/;

/**
 * Parses a robot's address.
 * @throws ClientError bad-address, with a hint for common mistakes
 */
export function parseRobotAddress(text: string): RobotAddress {
  const address = text.trim();
  const match = address.length <= MAX_LENGTH ? ADDRESS.exec(address) : null;
  const [, origin, id, key] = match ?? [];
  if (origin === undefined || id === undefined || key === undefined) {
    throw new ClientError("bad-address", "This is not a robot's address", hintFor(address));
  }
  return { origin, id, key };
}

function hintFor(address: string): string {
  if (/^https?:\/\/[^/]+\/r\/[^#]+#?$/.test(address.slice(0, MAX_LENGTH))) {
    return 'The key after the # is missing: copy the whole address, and put it in "quotes" on a command line.';
  }
  if (address === "") {
    return "It is empty: copy the address from the page, under Remote.";
  }
  if (!/^https?:\/\//.test(address)) {
    return "An address begins with http:// or https://: copy the whole address from the page, under Remote.";
  }
  if (/^https?:\/\/HOST\b/.test(address)) {
    return "HOST, ID and KEY stand for your robot's address: copy it from the page, under Remote.";
  }
  return "An address looks like http://HOST/r/ID#KEY: copy it again from the page, under Remote.";
}
