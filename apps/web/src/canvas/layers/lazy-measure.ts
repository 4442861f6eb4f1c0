/** The tape is drawn by a file of its own: most visits measure nothing. */
import type { drawMeasure } from "./measure.ts";

let draw: typeof drawMeasure | null = null;

/** @throws when the file cannot be fetched */
export async function loadMeasure(): Promise<void> {
  ({ drawMeasure: draw } = await import("./measure.ts"));
}

/** What draws it; null before it is loaded. */
export function measureLayer(): typeof drawMeasure | null {
  return draw;
}
