/** The race that is on, if any: the ghosts, and what the robot itself took. Filled by `features/race`. */
import { createStore } from "zustand/vanilla";
import type { Finish } from "../worker/worker-messages.ts";

/** Where this tab stores the ghosts. */
export const RACE_KEY = "corridor.race";

export interface RaceGhost {
  id: number;
  /** A to D */
  badge: string;
  /** name of the program that its run began with */
  program: string;
  /** the same for two ghosts only if they are the same run */
  digest: string;
  /** null while it is loading */
  finish: Finish | null;
}

export interface RaceState {
  /** in the order of their badges; empty while no race is on */
  ghosts: readonly RaceGhost[];
  /** what the live run took to the goal; null while it has not reached it */
  you: Finish | null;
}

export function createRaceStore() {
  return createStore<RaceState>()(() => ({ ghosts: [], you: null }));
}
export type RaceStore = ReturnType<typeof createRaceStore>;
