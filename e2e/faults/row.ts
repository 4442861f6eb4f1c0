/**
 * A row of `npm run test:faults`: breaks something of the real service, and judges what became of
 * it.
 */
import type { Goal } from "../../benches/core/goals.ts";

export interface Terms {
  /** the length for a release; else the short one */
  isLong: boolean;
  /** for all chance of the row */
  seed: number;
  /** an empty folder, gone after the row */
  folder: string;
  /** Shows a line to who waits. */
  say(line: string): void;
  /** Is done once the row is over, whatever came of it; what was asked for last is done first. */
  after(clean: () => unknown): void;
}

export interface Row {
  /** words on the command line choose rows by it */
  title: string;
  /** what is done, for the report */
  does(isLong: boolean): string;
  /** Does it. What must hold are the goals that it answers with. */
  run(terms: Terms): Promise<readonly Goal[]>;
}
