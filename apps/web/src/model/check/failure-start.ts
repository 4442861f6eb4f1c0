/** Where the replay of a failed run starts: the failure needs its last seconds only. */
import { TICKS_PER_SECOND } from "@corridor/protocol";

const SHOWN_TICKS = 2 * TICKS_PER_SECOND;

/** @param tick of the failure @returns first tick of the replay */
export function failureStart(tick: number): number {
  return Math.max(0, tick - SHOWN_TICKS);
}
