/** How long a run goes on. */
export const untils = ["time", "goal", "bump"] as const;
export type Until = (typeof untils)[number];

export interface RunLimits {
  /** simulated time after which the run ends in any case */
  seconds: number;
  /** what may end it earlier */
  until: Until;
}
