/** The address of a robot in a message, with or without its key. */
import { invalidMessage } from "./invalid-message.ts";

const MAX_LENGTH = 400;
const ADDRESS =
  /^https?:\/\/[^/?#\s]+\/r\/(?<id>[A-Za-z0-9_-]{22})(?:#(?<key>[A-Za-z0-9_-]{8,64})?)?$/;

const EXPECTED =
  "the address of a robot, https://HOST/r/ID#KEY, as Copy address with key under Remote copies it";

/**
 * @param text null if the element is missing
 * @throws Refusal bad-request, which does not repeat the text, because it may contain a key
 */
export function readAddress(text: string | null): { id: string; key: string | null } {
  const match = text !== null && text.length <= MAX_LENGTH ? ADDRESS.exec(text) : null;
  const { id, key = null } = match?.groups ?? {};
  if (id === undefined) {
    throw invalidMessage("robot", text === null ? "nothing" : "another text", EXPECTED);
  }
  return { id, key };
}
