/** Loads the drawing code of the measuring tape on demand: most visits measure nothing. */
import type { drawMeasure } from "./measure.ts";

let draw: typeof drawMeasure | null = null;

/** @throws if the file cannot be loaded */
export async function loadMeasure(): Promise<void> {
  ({ drawMeasure: draw } = await import("./measure.ts"));
}

/** The drawing function; null until it is loaded. */
export function measureLayer(): typeof drawMeasure | null {
  return draw;
}
