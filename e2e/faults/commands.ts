/** Commands that the scenarios send. */
import type { Order } from "@corridor/protocol";
import type { SeededRandom } from "../../apps/relay/src/testing/faults/seeded-random.ts";

/** mostly short, since long times to live hide late commands */
const TTLS = [400, 400, 2_000, 10_000];

/**
 * A command that ends within a tenth of a second, so that the next one need not wait. Directions
 * alternate. No velocity command follows another one, because a queued velocity is replaced by the
 * newer.
 */
export function shortCommand(n: number): Order {
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

/** A random command of any kind, with varying times to live. */
export function randomCommand(random: SeededRandom): Order {
  const options = { ttl: random.pick(TTLS), replace: random.chance(0.05) };
  const chance = random.next();
  if (chance < 0.3) return { action: "turn", degrees: random.between(-30, 30), ...options };
  if (chance < 0.5) return { action: "move", distance: random.between(-20, 30), ...options };
  if (chance < 0.7) return { action: "drive", left: 0.3, right: -0.3, ...options };
  if (chance < 0.85) {
    return { action: "drive", left: 0.2, right: 0.1, milliseconds: 150, ...options };
  }
  if (chance < 0.92) return { action: random.pick(["left 90", "right 90"]), ...options };
  if (chance < 0.97) return { action: "forward", ...options };
  return { action: "stop", ...options };
}
