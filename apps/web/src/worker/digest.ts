/** The digest of a run beside the robot: which bits this browser gives. Asked for by tests only. */
import { CompiledProgram } from "@corridor/program";
import { replayDigest } from "@corridor/simulation";
import type { ToWorker } from "./worker-messages.ts";

export function digestOf({ maze, driver, ticks }: Extract<ToWorker, { type: "digest" }>): string {
  const decider = "rules" in driver ? new CompiledProgram(driver) : driver;
  return replayDigest({ maze, driver: decider }, ticks);
}
