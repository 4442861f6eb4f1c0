/**
 * Problems of access that a relay reports, and that a client derives from a close code, which has no
 * space for sentences.
 */
export const accessProblems = {
  "not-authorised": { status: 401, title: "Missing or invalid key" },
  forbidden: { status: 403, title: "The key does not permit this request" },
  blocked: { status: 403, title: "Script blocked" },
  "no-robot": { status: 404, title: "Robot not found" },
} as const;

/** The `detail` of `not-authorised` for a request with a key. */
export const WRONG_KEY =
  "The key is invalid or was revoked. Copy the whole address again, with the part after the #: press 'Copy address with key' under Remote on the robot's page.";

/** The `detail` of `blocked`. */
export const BLOCKED_SCRIPT =
  "The robot's owner has blocked this script. Ask the owner to press 'Unblock', then restart the script.";

/** The `detail` of `no-robot`. */
export const UNKNOWN_ROBOT =
  "Check the id for typing errors, or copy the address again from the robot's page. The relay deletes robots after 2 hours without use, and 24 hours after their registration.";
