/**
 * Driving by hand: what a held key asks of the robot.
 */
import type { Command } from "@corridor/protocol";
import type { DriveKey } from "../worker/worker-messages.ts";

/** Longest turn that the protocol knows; nobody holds a key for ten rounds. */
const WHILE_HELD = 3_600;

/**
 * The command for a held key. Left and right turn on the spot at the speed of every turn, so that the
 * heading stays a whole number of steps and a quarter turn can be met exactly.
 */
export function commandOfKey(key: DriveKey): Command {
  switch (key) {
    case "left":
      return { action: "turn", degrees: -WHILE_HELD };
    case "right":
      return { action: "turn", degrees: WHILE_HELD };
    case "forward":
    case "reverse":
    case "stop":
      return { action: key };
  }
}
