/** What can go wrong on a script's side of the line; never sent over it. */

export type ClientErrorCode =
  /** the robot's address cannot be read */
  | "bad-address"
  /** the command has a wrong number or word; `hint` names it */
  | "bad-command"
  /** the key is wrong, or does not allow this */
  | "not-authorised"
  /** the robot's owner has sent this script away */
  | "sent-away"
  /** there is no robot with this address any more */
  | "no-robot"
  /** the relay refused the command for another reason */
  | "refused"
  /** the robot, its user or a stop ended the command */
  | "cancelled"
  /** it was not started within its time to live */
  | "expired"
  /** a later command took its place */
  | "superseded"
  /** no answer in time */
  | "timeout"
  /** the robot's page is away and has not come back in time */
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

/** An error with a stable code, and a hint that says how to go on. */
export class ClientError extends Error {
  override readonly name = "ClientError";
  readonly code: ClientErrorCode;
  readonly hint: string;

  constructor(code: ClientErrorCode, what: string, hint: string, options?: ErrorOptions) {
    super(`${what} (${code}). ${hint}`, options);
    this.code = code;
    this.hint = hint;
  }
}
