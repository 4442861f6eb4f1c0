/**
 * The current race, if any: the ghosts, and the result of the robot itself. Written by
 * `features/race`.
 */
import { createStore } from "zustand/vanilla";
import type { Finish } from "../../simulator/protocol/worker-messages.ts";

/** Session storage key of the ghosts. */
export const RACE_KEY = "corridor.race";

export interface RaceGhost {
  id: number;
  /** A to G */
  badge: string;
  /** name of the program at the start of its run */
  program: string;
  /** equal for two ghosts only if they are the same run */
  digest: string;
  /** null while it is loading */
  finish: Finish | null;
}

export interface RaceState {
  /** in the order of their badges; empty without a race */
  ghosts: readonly RaceGhost[];
  /** result of the live run; null until it reaches the goal */
  you: Finish | null;
}

export function createRaceStore() {
  return createStore<RaceState>()(() => ({ ghosts: [], you: null }));
}
export type RaceStore = ReturnType<typeof createRaceStore>;
