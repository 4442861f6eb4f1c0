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
  override readonly name = "ClientError";
  /** stable code for scripts */
  readonly code: ClientErrorCode;
  /** how to fix it */
  readonly hint: string;

  constructor(code: ClientErrorCode, what: string, hint: string, options?: ErrorOptions) {
    super(`${what}${what.endsWith(code) ? "" : ` (${code})`}. ${hint}`, options);
    this.code = code;
    this.hint = hint;
  }
}
