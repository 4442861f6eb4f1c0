/** Opening a run in tests of the loop, without slices. */
import { openRun, type RunDocument } from "@corridor/recording";
import type { RunLoop } from "../run-loop.ts";
import type { LoadedRun } from "../../protocol/worker-messages.ts";

/** Opens a run at once; the worker does it in slices. */
export function loadRun(loop: RunLoop, run: RunDocument, until?: number): LoadedRun {
  const opened = openRun(run, until);
  return opened.ok ? loop.open(opened.value) : { ...opened, reason: "refused" };
}
