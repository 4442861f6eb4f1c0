/** Numbers of the run as the panels show them. */

/** Ticks in a second of simulated time. */
const TICKS_PER_SECOND = 60;

/** A reading in cm for the eye: at most one decimal, and none where it is 0. */
export function formatReading(centimetres: number): string {
  return String(Number(centimetres.toFixed(1)));
}

/** Simulated time as minutes, seconds and tenths, cut and never rounded up: 1063 ticks are "0:17.7". */
export function formatClock(tick: number): string {
  const tenths = Math.floor((tick * 10) / TICKS_PER_SECOND);
  const minutes = Math.floor(tenths / 600);
  const seconds = (tenths % 600) / 10;
  return `${minutes}:${seconds.toFixed(1).padStart(4, "0")}`;
}

/** Simulated time in seconds with one decimal, cut as the clock's: "39.2". */
export function formatSeconds(tick: number): string {
  return (Math.floor((tick * 10) / TICKS_PER_SECOND) / 10).toFixed(1);
}
