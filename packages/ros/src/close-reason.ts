import { closeReasons, type CloseReason, type ProblemDocument } from "@corridor/protocol";

/** By status of the problem. */
const reasons: Readonly<Record<number, CloseReason>> = {
  401: closeReasons.notAuthorised,
  403: closeReasons.forbidden,
  404: closeReasons.noRobot,
  408: closeReasons.tooSlow,
  429: closeReasons.tooMany,
};

/** How the connection of a ROS client closes because of a problem. */
export function closeReasonFor({ type, status }: ProblemDocument): CloseReason {
  if (type === "/problems/restarting") return closeReasons.restart;
  return reasons[status] ?? closeReasons.busy;
}
