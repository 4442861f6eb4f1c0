/** Driving by hand: the command of a held key. */
import type { Command } from "@corridor/protocol";
import type { DriveKey } from "../protocol/worker-messages.ts";

/** Longest turn of the protocol: ten full turns, more than a key is ever held. */
const WHILE_HELD = 3_600;

/**
 * The command of a held key. Left and right turn on the spot at the speed of every turn, so that
 * the heading is always a whole number of steps and a quarter turn can be reached exactly.
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
