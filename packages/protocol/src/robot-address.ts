/** The address of a robot, simulated or physical: `https://HOST/r/ID#KEY`. */

const MAX_LENGTH = 400;
const ADDRESS = /^(https?:\/\/[^/?#\s@]+)\/r\/([A-Za-z0-9_-]{1,64})(?:#([A-Za-z0-9_-]{8,64})?)?$/;

export interface RobotAddress {
  /** such as https://robots.example.org */
  origin: string;
  /** This relay creates ids of 22 characters; other hosts have ids of 1 to 64. */
  id: string;
  key: string;
}

/** @returns the parts of an address, whose key may be missing; null if it is not one */
export function readRobotAddress(
  text: string,
): (Omit<RobotAddress, "key"> & { key: string | null }) | null {
  const match = text.length <= MAX_LENGTH ? ADDRESS.exec(text) : null;
  const [, origin, id, key = null] = match ?? [];
  return origin === undefined || id === undefined ? null : { origin, id, key };
}
