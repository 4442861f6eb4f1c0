/** Commands that rows send. */
import type { Order } from "@corridor/protocol";

/** One that is done within a tenth of a second, so that the next need not wait for it; to and fro. */
export function shortOrder(n: number): Order {
  const isBack = n % 2 === 1;
  switch (n % 6) {
    case 0:
    case 1:
      return { action: "turn", degrees: isBack ? -2 : 2 };
    case 2:
    case 3:
      return { action: "drive", left: isBack ? -0.1 : 0.1, right: isBack ? -0.1 : 0.1 };
    default:
      return {
        action: "drive",
        left: isBack ? -0.1 : 0.1,
        right: isBack ? -0.1 : 0.1,
        milliseconds: 50,
      };
  }
}
