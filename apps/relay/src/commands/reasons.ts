/**
 * Why commands ended. A row holds the relay's cause, or the sentence with which the robot reported
 * the ending. A cause becomes a sentence when the row becomes a record for readers.
 */
import {
  BLOCKED_REASON,
  expiredReason,
  PAUSED_REASON,
  recallCauses,
  RELOADED_REASON,
  REVOKED_REASON,
  type RecallCause,
} from "@corridor/protocol";

/** What happened to the page that owned the robot, if it can neither end nor report its commands. */
export type LeftCause =
  /** it is gone, and the new one was loaded in its place */
  | "reloaded"
  /** it may still exist */
  | "taken-over";

/** Why the relay ended a command. */
export const causes = [
  ...recallCauses,
  /** a later stop or replacing command overtook it */
  "stopped",
  "replaced",
  /** its deadline passed while a page was connected as the robot, or while none was */
  "expired",
  "expired-absent",
  /** the page that had it does not return */
  "disconnected",
  /** the page that had started it; `unsure`: that may have started it */
  "reloaded",
  "reloaded-unsure",
  "taken-over",
  "taken-over-unsure",
] as const;
export type Cause = (typeof causes)[number];

export interface RelayReason {
  cause: Cause;
  /** seq of the command that stopped or replaced it; null for other causes */
  by: number | null;
}

/** The relay's reason, or the sentence of the robot. */
export type Reason = RelayReason | string;

const NEW_COMMAND = "Send a new command.";
const CHECK_POSITION =
  "and this command may have started. Check where the robot is, then send a new command.";

const sentences: Record<Cause, string | ((by: number | null, ttl: number) => string)> = {
  sender: "The script cancelled this command before it started. To run it, send a new command.",
  revoked: REVOKED_REASON,
  blocked: BLOCKED_REASON,
  paused: PAUSED_REASON,
  stopped: (by) => `Command ${by} stopped this command.`,
  replaced: (by) => `Command ${by} replaced this command.`,
  expired: (_by, ttl) => expiredReason(ttl),
  "expired-absent": (_by, ttl) => expiredReason(ttl, "absent"),
  disconnected:
    "The robot disconnected. Check that its page is open and connected under Remote, then send a new command.",
  reloaded: RELOADED_REASON,
  "reloaded-unsure": `The robot's page was reloaded, ${CHECK_POSITION}`,
  "taken-over": `Another page took over the robot and ended this command. ${NEW_COMMAND}`,
  "taken-over-unsure": `Another page took over the robot, ${CHECK_POSITION}`,
};

/** The sentence for readers. @param ttl of the command, in ms */
export function reasonText(reason: Reason, ttl: number): string {
  if (typeof reason === "string") return reason;
  const sentence = sentences[reason.cause];
  return typeof sentence === "string" ? sentence : sentence(reason.by, ttl);
}

/**
 * The stored cause of a recall. Earlier versions of Corridor stored a sentence, which counts as a
 * request of the sender.
 */
export function recallCauseIn(text: string | null): RecallCause | null {
  return text === null ? null : (recallCauses.find((cause) => cause === text) ?? "sender");
}
