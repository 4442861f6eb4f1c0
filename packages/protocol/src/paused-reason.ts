/** A file of its own: the page's worker needs no schema for it. */

/** For the script whose command a pause of remote driving ended or refused. */
export const PAUSED_REASON =
  "The owner paused remote driving. Press 'Let scripts drive' under Remote on the robot's page, then send a new command.";
