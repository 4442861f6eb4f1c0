/** The address of a robot in a message, with or without its key. */
import { readRobotAddress } from "@corridor/protocol";
import { invalidMessage } from "./invalid-message.ts";

const EXPECTED =
  "the address of a robot, https://HOST/r/ID#KEY, as Copy address with key under Remote copies it";

/**
 * @param text null if the element is missing
 * @throws Refusal bad-request, which does not repeat the text, because it may contain a key
 */
export function readAddress(text: string | null): { id: string; key: string | null } {
  const address = text === null ? null : readRobotAddress(text);
  if (address === null) {
    throw invalidMessage("robot", text === null ? "nothing" : "another text", EXPECTED);
  }
  return { id: address.id, key: address.key };
}
