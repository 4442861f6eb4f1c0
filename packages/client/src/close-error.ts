import {
  BLOCKED_SCRIPT,
  closeReasons,
  keyPrefixes,
  UNKNOWN_ROBOT,
  WRONG_KEY,
  type CloseReason,
  type RobotAddress,
} from "@corridor/protocol";
import { ClientError } from "./client-error.ts";

const COPY = "press 'Copy address with key' under Remote on the robot's page.";

/** Whether the key permits only reading. */
export function isWatchKey(key: string): boolean {
  return key.startsWith(keyPrefixes.watch);
}

/** The error of a command by a script with a watch key. */
export function watchLinkError(): ClientError {
  const what = "This is a watch link: it can only read";
  return new ClientError("not-authorised", what, `Copy the robot's address: ${COPY}`);
}

/**
 * The error of a script whose connection was closed without retry. The hints are those of the
 * relay's HTTP responses, because a close frame has no space for them.
 * @param robot the address of the script
 */
export function closeError({ code, cause, remedy }: CloseReason, robot: RobotAddress): ClientError {
  switch (code) {
    case closeReasons.notAuthorised.code:
      return new ClientError("not-authorised", "The robot rejects this key", WRONG_KEY);
    case closeReasons.forbidden.code:
      if (isWatchKey(robot.key)) return watchLinkError();
      // A driver key permits everything that a script does: the script is blocked.
      if (robot.key.startsWith(keyPrefixes.drive)) return blocked();
      return new ClientError("not-authorised", "The robot rejects this key", remedy);
    case closeReasons.noRobot.code:
      return new ClientError("no-robot", `No robot has the id ${robot.id}`, UNKNOWN_ROBOT);
    default:
      return new ClientError("no-robot", `Not connected: ${cause}`, remedy);
  }
}

function blocked(): ClientError {
  return new ClientError("blocked", "This script is blocked", BLOCKED_SCRIPT);
}
