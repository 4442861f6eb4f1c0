/** The refusal of a message that does not match the WSDL. */
import { badRequest, type Refusal } from "../../platform/errors/problems.ts";

/** Names of elements and namespaces may be long. */
const MAX_LENGTH = 160;

/** @param path where, such as `until[0].is` */
export function invalidMessage(path: string, found: string, expected: string): Refusal {
  const problem = { path: shorten(path), found: shorten(found), expected };
  return badRequest("Invalid message.", [problem]);
}

function shorten(text: string): string {
  return text.length > MAX_LENGTH ? `${text.slice(0, MAX_LENGTH)}…` : text;
}
