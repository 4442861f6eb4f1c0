/** The winner of a race, by the time to the goal. */
import type { RaceState } from "../../model/run/race-store.ts";

export type RaceResult =
  /** the robot has not reached the goal */
  | { kind: "waiting" }
  /** no ghost has reached the goal */
  | { kind: "alone" }
  /** the winner, the best ghost, and the ticks between that ghost and the robot */
  | { kind: "you" | "ghost" | "same"; badge: string; ticks: number };

export function raceResult({ ghosts, you }: RaceState): RaceResult {
  const mine = you?.goalTick ?? null;
  if (mine === null) return { kind: "waiting" };
  let best: { badge: string; tick: number } | null = null;
  for (const { badge, finish } of ghosts) {
    const tick = finish?.goalTick ?? null;
    if (tick !== null && (best === null || tick < best.tick)) best = { badge, tick };
  }
  if (best === null) return { kind: "alone" };
  const ticks = Math.abs(best.tick - mine);
  const kind = ticks === 0 ? "same" : mine < best.tick ? "you" : "ghost";
  return { kind, badge: best.badge, ticks };
}
