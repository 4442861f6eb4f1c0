/** Loads the drawing code of race ghosts on demand: most visits have no race. */
import type { drawRaceGhosts } from "./race-ghosts.ts";

let draw: typeof drawRaceGhosts | null = null;

/** @throws if the file cannot be loaded */
export async function loadRaceGhosts(): Promise<void> {
  ({ drawRaceGhosts: draw } = await import("./race-ghosts.ts"));
}

/** The drawing function; null until it is loaded. */
export function raceGhostsLayer(): typeof drawRaceGhosts | null {
  return draw;
}
