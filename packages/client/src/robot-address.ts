/** The address of a robot, `https://HOST/r/ID#KEY`: everything that a script needs. */
import { readRobotAddress, type RobotAddress } from "@corridor/protocol";
import { ClientError } from "./client-error.ts";

const NO_ADDRESS = "This is not a robot's address";

/**
 * Parses a robot's address.
 * @throws ClientError bad-address, with a hint for common mistakes
 */
export function parseRobotAddress(text: string): RobotAddress {
  const given: unknown = text; // JavaScript passes anything
  if (typeof given !== "string") {
    const hint =
      "An address is a text in quotes: copy the whole address from the page, under Remote.";
    throw new ClientError("bad-address", NO_ADDRESS, hint);
  }
  const address = given.trim();
  const parts = readRobotAddress(address);
  if (parts === null || parts.key === null) {
    throw new ClientError("bad-address", NO_ADDRESS, hintFor(address));
  }
  return { ...parts, key: parts.key };
}

function hintFor(address: string): string {
  if (/^https?:\/\/[^/?#\s]*@/.test(address)) {
    return "It contains a user name before the @: copy the whole address from the page, under Remote.";
  }
  if (/^https?:\/\/[^/]+\/r\/[^#]+#?$/.test(address)) {
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
