/** The time of a class on the clock of this device. Pure. */
import type { ClassTime } from "./classroom-messages.ts";

/** Active time of the class at a moment. @param now ms since 1970 */
export function activeMsAt({ at, activeMs, pauseEndsAt }: ClassTime, now: number): number {
  const from = pauseEndsAt === null ? at : Math.max(at, pauseEndsAt);
  return activeMs + Math.max(0, now - from);
}

/** The time after a pause starts or ends. @param pauseEndsInMs null: not paused */
export function withPause(time: ClassTime, now: number, pauseEndsInMs: number | null): ClassTime {
  const pauseEndsAt = pauseEndsInMs === null ? null : now + pauseEndsInMs;
  return { ...time, at: now, activeMs: activeMsAt(time, now), pauseEndsAt };
}
