/**
 * Why a WebSocket was closed: every code that the relay uses, with its cause and what helps.
 * `retry` says whether the same connection can succeed when it is tried again.
 */
export interface CloseReason {
  code: number;
  cause: string;
  remedy: string;
  retry: boolean;
}

export const closeReasons = {
  restart: {
    code: 1012,
    cause: "the relay is being restarted",
    remedy: "It comes back by itself; connect again.",
    retry: true,
  },
  busy: {
    code: 1013,
    cause: "the relay could not store what was sent",
    remedy: "Connect again in a few seconds.",
    retry: true,
  },
  badFrame: {
    code: 4400,
    cause: "a message could not be read",
    remedy: "Send JSON text in the shapes that docs/protocol.md lists.",
    retry: true,
  },
  notAuthorised: {
    code: 4401,
    cause: "no valid key came in time, or it was revoked",
    remedy: "Copy the robot's address again, with everything after the #.",
    retry: false,
  },
  forbidden: {
    code: 4403,
    cause: "this key does not allow that, or the robot's owner has blocked this script",
    remedy:
      "Scripts use the driver key. A blocked script waits until the robot's owner unblocks it.",
    retry: false,
  },
  noRobot: {
    code: 4404,
    cause: "there is no robot with this id",
    remedy:
      "Robots are forgotten after 2 hours without use: open the page and copy the new address.",
    retry: false,
  },
  tooSlow: {
    code: 4408,
    cause: "messages were not read fast enough",
    remedy: "Connect again, and read messages while the script works.",
    retry: true,
  },
  replaced: {
    code: 4409,
    cause: "another page took this robot over",
    remedy: "Go on in the other page, or reload this one to take the robot back.",
    retry: false,
  },
  over: {
    code: 4410,
    cause: "the session of this robot was deleted or has run out",
    remedy: "Register the robot again for a new address.",
    retry: false,
  },
  tooMany: {
    code: 4429,
    cause: "too many connections use this robot",
    remedy: "End scripts that you no longer need, then connect again.",
    retry: true,
  },
} as const satisfies Record<string, CloseReason>;

/** Codes of the WebSocket protocol itself that a reader may meet; everything else is just a lost line. */
const LOST: CloseReason = {
  code: 1006,
  cause: "the connection was lost",
  remedy: "It is tried again by itself.",
  retry: true,
};

const byCode = new Map<number, CloseReason>(
  Object.values(closeReasons).map((reason) => [reason.code, reason]),
);

/** The reason behind a close code; a code that this project does not use counts as a lost connection. */
export function closeReasonOf(code: number): CloseReason {
  return byCode.get(code) ?? { ...LOST, code };
}
