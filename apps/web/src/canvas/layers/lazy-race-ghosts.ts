/** The ghosts of a race are drawn by a file of its own: most visits have no race. */
import type { drawRaceGhosts } from "./race-ghosts.ts";

let draw: typeof drawRaceGhosts | null = null;

/** @throws when the file cannot be fetched */
export async function loadRaceGhosts(): Promise<void> {
  ({ drawRaceGhosts: draw } = await import("./race-ghosts.ts"));
}

/** What draws them; null before it is loaded. */
export function raceGhostsLayer(): typeof drawRaceGhosts | null {
  return draw;
}
