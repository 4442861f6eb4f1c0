/** Limits of a run: its simulated time, and the event that may end it earlier. */
export const runEnds = ["time", "goal", "bump"] as const;
export type RunEnd = (typeof runEnds)[number];

export interface RunLimits {
  /** maximum simulated time in seconds */
  seconds: number;
  /** the event that ends the run; "time" runs for all `seconds` */
  until: RunEnd;
}
