/**
 * Reasons of commands that the owner, a reload of the page or a silent script ended, with what to do
 * next. In its own file so that the page's worker imports no schemas.
 */

/**
 * Words in the reason of a command whose script was silent for so long that its lease ended. A record
 * has no cause as a code, so exported programs look for these words. The page and the example of a
 * physical robot write them.
 */
export const SILENT_WORDS = "stopped sending";

/** The lease of the script ended, for example because its connection was lost. */
export const SILENT_REASON = `The script ${SILENT_WORDS}, so the robot stopped. Send commands or read the robot more often.`;

/** Remote driving is paused. */
export const PAUSED_REASON =
  "The owner paused remote driving. Press 'Let scripts drive' under Remote on the robot's page, then send a new command.";

/** The page was reloaded while it executed the command. The page and the relay both end it. */
export const RELOADED_REASON =
  "The robot's page was reloaded and ended this command. Send a new command.";

export const REVOKED_REASON =
  "The owner revoked the key that sent this command. Ask the owner for the robot's new address.";

export const BLOCKED_REASON =
  "The owner blocked the script that sent this command. Press 'Unblock' under Remote, More on the robot's page, then start the script again.";
