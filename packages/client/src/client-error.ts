/** Stable codes for scripts. They are local and not part of the protocol. */
export type ClientErrorCode =
  /** the robot's address is invalid */
  | "bad-address"
  /** a parameter of the command is invalid; `hint` names it */
  | "bad-command"
  /** the key is wrong, or does not permit this */
  | "not-authorised"
  /** the robot's owner has blocked this script */
  | "blocked"
  /** there is no robot with this address: the relay deletes robots after 2 hours without use */
  | "no-robot"
  /** the relay refused the command for another reason */
  | "refused"
  /** a stop, the robot's owner, a reload or the robot itself ended the command */
  | "cancelled"
  /** the command could not start within its `ttl` */
  | "expired"
  /** a newer command replaced it */
  | "superseded"
  /** the relay did not respond in time, or the robot did not finish in time */
  | "timeout"
  /** the robot's page is closed and was not reopened in time */
  | "robot-gone"
  /** the robot's host does not publish its maze */
  | "no-maze"
  /** no page shows this pairing code, or another script has used it */
  | "wrong-code"
  /** the robot's owner refused this script */
  | "pairing-refused"
  /** the owner did not answer, or the code has expired */
  | "pairing-over"
  /** too many wrong pairing codes were entered */
  | "too-many-tries"
  /** this client was closed */
  | "closed";

/**
 * Every error of this library. `message` contains the cause, `code` and `hint`, and never the key.
 */
export class ClientError extends Error {
  /** the name in logs */
  declare readonly name: "ClientError";
  /** stable code for scripts */
  declare readonly code: ClientErrorCode;
  /** how to fix it */
  declare readonly hint: string;

  constructor(code: ClientErrorCode, what: string, hint: string, options?: ErrorOptions) {
    super(`${what}${what.endsWith(code) ? "" : ` (${code})`}. ${hint}`, options);
    describe(this, { name: "ClientError", code, hint });
  }
}

/**
 * Runs a call of a script. Its error has the stack of that call, so that Node prints the line of the
 * script for an uncaught error instead of a line of this library.
 * @param name a public method of `owner`; its frame and those below are omitted
 */
export async function withCallSite<T>(
  owner: object,
  name: string,
  run: () => Promise<T>,
): Promise<T> {
  const { captureStackTrace } = Error as StackCapture;
  const error = new ClientError("closed", "", "");
  const call: { stack?: string } = {};
  const method: unknown = Reflect.get(owner, name);
  captureStackTrace?.(error, method);
  captureStackTrace?.(call, method);
  try {
    return await run();
  } catch (reason) {
    if (captureStackTrace === undefined || !(reason instanceof ClientError)) throw reason;
    const { message, code, hint } = reason;
    // V8 drops the line of the script when the stack of the error itself is read or assigned.
    const lines = (call.stack ?? "").split("\n");
    const frames = lines.filter((line) => /^ +at |@/.test(line) && !ENGINE_FRAME.test(line));
    delete error.stack;
    describe(error, {
      message,
      code,
      hint,
      stack: [`${error.name}: ${message}`, ...frames].join("\n"),
    });
    throw error;
  }
}

/** A stack frame of Node itself. */
const ENGINE_FRAME = /^ +at .*\bnode:internal\//;

/** Only in some engines. */
interface StackCapture {
  captureStackTrace?: (on: object, above: unknown) => void;
}

/** Sets properties that Node does not print after the stack, because `message` contains them. */
function describe(error: ClientError, values: Record<string, unknown>): void {
  for (const [name, value] of Object.entries(values)) {
    Object.defineProperty(error, name, { value, writable: true, configurable: true });
  }
}
