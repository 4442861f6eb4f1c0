/** Where the robots of a race are, and how fast the race is displayed. Pure. */
import { TICKS_PER_SECOND } from "@corridor/protocol";
import { blendHeading } from "../../simulator/protocol/blend-heading.ts";
import { TICKS_PER_POSE, type RacedRun } from "../../simulator/protocol/pool-messages.ts";

/** A class watches a race for this long at most, in seconds. */
const LONGEST_SECONDS = 45;

export interface RacePose {
  x: number;
  y: number;
  heading: number;
}

/** The pose at a tick, between two poses of the run. A robot stays at its end. */
export function poseAt({ poses, ticks }: RacedRun, tick: number): RacePose {
  const at = Math.max(0, Math.min(tick, ticks));
  const from = Math.min(Math.floor(at / TICKS_PER_POSE), poses.length / 3 - 1);
  const to = Math.min(from + 1, poses.length / 3 - 1);
  const fromTick = from * TICKS_PER_POSE;
  const toTick = Math.min(to * TICKS_PER_POSE, ticks);
  const share = toTick === fromTick ? 0 : (at - fromTick) / (toTick - fromTick);
  const [x = 0, y = 0, heading = 0] = poses.subarray(3 * from, 3 * from + 3);
  const [toX = x, toY = y, toHeading = heading] = poses.subarray(3 * to, 3 * to + 3);
  return {
    x: x + share * (toX - x),
    y: y + share * (toY - y),
    heading: blendHeading(heading, toHeading, share),
  };
}

/** The tick at which the last robot has solved the task or failed. */
export function lastTick(runs: readonly RacedRun[]): number {
  return Math.max(0, ...runs.map(({ ticks }) => ticks));
}

/** 1, 2, 4 ...: the speed at which the race ends in time. */
export function raceSpeed(runs: readonly RacedRun[]): number {
  const seconds = lastTick(runs) / TICKS_PER_SECOND;
  return seconds <= LONGEST_SECONDS ? 1 : 2 ** Math.ceil(Math.log2(seconds / LONGEST_SECONDS));
}
