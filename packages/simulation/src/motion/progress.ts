/** How far a running manoeuvre is. */
import type { Command } from "@corridor/protocol";

export interface Progress {
  action: Command["action"];
  /** the part that runs, from 0, and how many there are: a delayed turn drives, turns, drives */
  part: number;
  parts: number;
  kind: "drive" | "turn" | "wheels";
  /** 1 along the heading or clockwise, -1 against */
  way: 1 | -1;
  /** what the part has still to do: units of a drive, degrees of a turn, ticks of wheels */
  left: number;
  /** what it had to do when it began */
  of: number;
}
