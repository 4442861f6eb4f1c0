/**
 * What a bump comes down to: the room that the robot needed against the room it had. Data only; the
 * page makes the sentences.
 */
import type { Command } from "@corridor/protocol";
import { ROBOT_RADIUS } from "@corridor/simulation";

/** What is known of a bump when it happens. Lengths in units. */
export interface BumpFacts {
  action: Command["action"];
  /** part of the manoeuvre that met the wall, from 0 */
  part: number;
  /** which way the robot drove */
  side: "front" | "back";
  /** what the sensor on that side measured when the part began, from the robot's middle */
  reading: number;
  /** what the part had to drive; null for a motion that lasts until something else is chosen */
  needed: number | null;
}

export interface BumpStory {
  /**
   * delay: a delayed turn met the wall before it turned; way-out: after it had turned; measured: a
   * distance was too long; steady: nothing else was chosen in time
   */
  kind: "delay" | "way-out" | "measured" | "steady";
  side: "front" | "back";
  /** units that the part had to drive; null where it had no end of its own */
  needs: number | null;
  /** units between the robot's edge and the wall when it set off */
  free: number;
}

export function storyOfBump({ action, part, side, reading, needed }: BumpFacts): BumpStory {
  const isDelayed = action === "delayed left 90" || action === "delayed right 90";
  const kind =
    needed === null ? "steady" : !isDelayed ? "measured" : part === 0 ? "delay" : "way-out";
  return { kind, side, needs: needed, free: Math.max(0, reading - ROBOT_RADIUS) };
}
