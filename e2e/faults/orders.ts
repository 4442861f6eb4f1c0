/** Commands that rows send. */
import type { Order } from "@corridor/protocol";
import type { Dice } from "../../apps/relay/src/testing/faults/dice.ts";

/** Long ones hide what short ones show. */
const TTLS = [400, 400, 2_000, 10_000];

/**
 * One that is done within a tenth of a second, so that the next need not wait for it; to and fro.
 * No velocity follows on another one, for of two that wait the newer takes the place of the older.
 */
export function shortOrder(n: number): Order {
  const isBack = n % 2 === 1;
  const power = isBack ? -0.1 : 0.1;
  switch (n % 4) {
    case 0:
    case 1:
      return { action: "turn", degrees: isBack ? -2 : 2 };
    case 2:
      return { action: "drive", left: power, right: power };
    default:
      return { action: "drive", left: power, right: power, milliseconds: 50 };
  }
}

/** Anything that a script may ask for, with all times to live. */
export function anyOrder(dice: Dice): Order {
  const terms = { ttl: dice.pick(TTLS), replace: dice.isLucky(0.05) };
  const chance = dice.next();
  if (chance < 0.3) return { action: "turn", degrees: dice.between(-30, 30), ...terms };
  if (chance < 0.5) return { action: "move", distance: dice.between(-20, 30), ...terms };
  if (chance < 0.7) return { action: "drive", left: 0.3, right: -0.3, ...terms };
  if (chance < 0.85) {
    return { action: "drive", left: 0.2, right: 0.1, milliseconds: 150, ...terms };
  }
  if (chance < 0.92) return { action: dice.pick(["left 90", "right 90"]), ...terms };
  if (chance < 0.97) return { action: "forward", ...terms };
  return { action: "stop", ...terms };
}
