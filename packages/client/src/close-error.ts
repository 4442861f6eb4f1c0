/** What a script is told when its line was closed for good. */
import { closeReasons, type CloseReason } from "@corridor/protocol";
import { ClientError } from "./client-error.ts";

/** @param key by which the script came */
export function closeError({ code, cause, remedy }: CloseReason, key: string): ClientError {
  // A driver key may do all that a script does, so what is forbidden to it is to be here at all.
  if (code === closeReasons.forbidden.code && key.startsWith("drv_")) {
    return new ClientError(
      "blocked",
      "This script is blocked",
      "The robot's owner has blocked this script. Ask them to press Unblock under Remote, then start it again.",
    );
  }
  const isKey = code === closeReasons.notAuthorised.code || code === closeReasons.forbidden.code;
  return new ClientError(isKey ? "not-authorised" : "no-robot", `Not connected: ${cause}`, remedy);
}
