/** What can go wrong for a script. These codes never travel. */

/** What went wrong, as a stable word for scripts. */
export type ClientErrorCode =
  /** the robot's address cannot be read */
  | "bad-address"
  /** the command has a wrong number or word; `hint` names it */
  | "bad-command"
  /** the key is wrong, or does not allow this */
  | "not-authorised"
  /** the robot's owner has blocked this script, until it is allowed again */
  | "blocked"
  /** there is no robot with this address (any more): robots are deleted after 2 hours without use */
  | "no-robot"
  /** the relay refused the command for another reason */
  | "refused"
  /** a stop, the robot's owner, a reload or the robot itself ended the command */
  | "cancelled"
  /** the command could not start within its `ttl` */
  | "expired"
  /** a newer command replaced it */
  | "superseded"
  /** the relay did not answer, or the robot did not finish, in time */
  | "timeout"
  /** the robot's page is closed, and was not opened again in time */
  | "robot-gone"
  /** the robot's host does not publish its maze */
  | "no-maze"
  /** no page shows this pairing code, or another script has asked by it */
  | "wrong-code"
  /** the robot's owner said no to this script */
  | "pairing-refused"
  /** nobody has answered, or the code was taken back */
  | "pairing-over"
  /** too many wrong pairing codes were typed */
  | "too-many-tries"
  /** this client was closed */
  | "closed";

/** Every error of this library. `message` has what went wrong, `code` and `hint`, and never the key. */
export class ClientError extends Error {
  /** by which a log tells it from other errors */
  override readonly name = "ClientError";
  /** a stable word for scripts */
  readonly code: ClientErrorCode;
  /** what to do */
  readonly hint: string;

  constructor(code: ClientErrorCode, what: string, hint: string, options?: ErrorOptions) {
    super(`${what}${what.endsWith(code) ? "" : ` (${code})`}. ${hint}`, options);
    this.code = code;
    this.hint = hint;
  }
}
