/**
 * Reasons of commands that the owner cancelled or refused, with what to do next. In its own file so
 * that the page's worker imports no schemas.
 */

/** Remote driving is paused. */
export const PAUSED_REASON =
  "The owner paused remote driving. Press 'Let scripts drive' under Remote on the robot's page, then send a new command.";

export const REVOKED_REASON =
  "The owner revoked the key that sent this command. Ask the owner for the robot's new address.";

export const BLOCKED_REASON =
  "The owner blocked the script that sent this command. Press 'Unblock' under Remote, More on the robot's page, then start the script again.";
