/** Progress of a running manoeuvre. */
import type { Command } from "@corridor/protocol";

export interface Progress {
  action: Command["action"];
  /** index of the current part, and number of parts: a delayed turn drives, turns, drives */
  part: number;
  parts: number;
  kind: "drive" | "turn" | "wheels";
  /** 1 forward or clockwise, -1 backward or anticlockwise */
  direction: 1 | -1;
  /** remaining amount of the part: units of a drive, degrees of a turn, ticks of wheel speeds */
  left: number;
  /** total amount of the part */
  of: number;
}
