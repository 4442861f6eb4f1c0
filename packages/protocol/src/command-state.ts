/**
 * The states of a remote command: accepted (stored by the relay) → delivered (about to be sent to
 * the robot) → started → one ending. An ending is final.
 *
 * This file imports nothing, so that the page can use it without the schemas.
 */
export const endingStates = [
  "completed",
  "collided",
  "cancelled",
  "superseded",
  /** its time to live ended before it started */
  "expired",
] as const;
export type EndingState = (typeof endingStates)[number];

export const commandStates = ["accepted", "delivered", "started", ...endingStates] as const;
export type CommandState = (typeof commandStates)[number];

/** Whether the state is final. */
export function hasEnded(state: CommandState): state is EndingState {
  return (endingStates as readonly CommandState[]).includes(state);
}
