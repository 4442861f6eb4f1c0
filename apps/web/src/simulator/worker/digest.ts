/** Digest of a run without a robot: the bits that this browser computes. For tests only. */
import { CompiledProgram } from "@corridor/program";
import { replayDigest } from "@corridor/simulation";
import type { ToWorker } from "../protocol/worker-messages.ts";

export function digestOf({ maze, driver, ticks }: Extract<ToWorker, { type: "digest" }>): string {
  const decider = "rules" in driver ? new CompiledProgram(driver) : driver;
  return replayDigest({ maze, driver: decider }, ticks);
}
