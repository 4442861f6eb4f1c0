/** The end of a step: how far Step goes. */
import type { Pose } from "@corridor/protocol";
import type { Run } from "@corridor/recording";

/**
 * Whether a tick has changed what the robot does: another line decides, a manoeuvre has started or
 * ended, or the robot has bumped or stands, because constant readings choose the same line for ever.
 * @param before state of the run before the tick
 */
export function isChangeOfDecision(run: Run, before: Pick<Run, "bumps" | "pose">): boolean {
  const isStanding = !run.isManoeuvring && isSamePose(run.pose, before.pose);
  return run.decidedAt === run.tick || run.bumps !== before.bumps || isStanding;
}

const isSamePose = (one: Pose, other: Pose): boolean =>
  one.x === other.x && one.y === other.y && one.heading === other.heading;
