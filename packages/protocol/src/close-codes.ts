/** Why the relay closed a WebSocket. */
export interface CloseReason {
  code: number;
  cause: string;
  /** how to fix it, as a sentence */
  remedy: string;
  /** whether the client may reconnect with the same address and key */
  retry: boolean;
}

export const closeReasons = {
  restart: {
    code: 1012,
    cause: "the relay is restarting",
    remedy: "Connect again in a few seconds.",
    retry: true,
  },
  busy: {
    code: 1013,
    cause: "the relay could not store the message",
    remedy: "Connect again in a few seconds.",
    retry: true,
  },
  badFrame: {
    code: 4400,
    cause: "a message could not be read",
    remedy: "Send JSON text in the formats that /asyncapi.json describes.",
    retry: true,
  },
  notAuthorised: {
    code: 4401,
    cause: "the relay received no valid key in time, or the key was revoked",
    remedy: "Copy the robot's address again, with everything after the #.",
    retry: false,
  },
  forbidden: {
    code: 4403,
    cause: "this key does not permit this connection, or the robot's owner blocked this script",
    remedy:
      "Scripts use the driver key. A blocked script waits until the robot's owner unblocks it.",
    retry: false,
  },
  noRobot: {
    code: 4404,
    cause: "the relay has no robot with this id",
    remedy: "Copy the address again: the relay deletes robots after 2 hours without use.",
    retry: false,
  },
  tooSlow: {
    code: 4408,
    cause: "the client did not read messages fast enough",
    remedy: "Connect again, and read messages while the script runs.",
    retry: true,
  },
  replaced: {
    code: 4409,
    cause: "another page took over this robot",
    remedy: "Continue in the other page, or reload this one to take the robot back.",
    retry: false,
  },
  over: {
    code: 4410,
    cause: "the robot was deleted or has expired",
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

/** Stands for all codes that are not in `closeReasons`. */
const LOST: CloseReason = {
  code: 1006,
  cause: "the connection was lost",
  remedy: "The client reconnects automatically.",
  retry: true,
};

const byCode = new Map<number, CloseReason>(
  Object.values(closeReasons).map((reason) => [reason.code, reason]),
);

/** The reason of a close code. A code that Corridor does not use means a lost connection. */
export function closeReasonOf(code: number): CloseReason {
  return byCode.get(code) ?? { ...LOST, code };
}
