import { closeReasons, type CloseReason } from "@corridor/protocol";
import { ClientError } from "./client-error.ts";

/** The error of a script whose connection was closed without retry. @param key of the script */
export function closeError({ code, cause, remedy }: CloseReason, key: string): ClientError {
  // A driver key permits everything that a script does: forbidden means that the script is blocked.
  if (code === closeReasons.forbidden.code && key.startsWith("drv_")) {
    return new ClientError(
      "blocked",
      "This script is blocked",
      "The robot's owner has blocked this script. Ask the owner to press 'Unblock', then restart the script.",
    );
  }
  const isKey = code === closeReasons.notAuthorised.code || code === closeReasons.forbidden.code;
  return new ClientError(isKey ? "not-authorised" : "no-robot", `Not connected: ${cause}`, remedy);
}
