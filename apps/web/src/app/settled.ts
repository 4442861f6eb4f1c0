/** When the page has time for what is not on the screen yet. */
import type { RunStore } from "../stores/run-store.ts";

/** Whoever does not press Run at once looks around first. */
const LATEST_MS = 5000;
/** The first moments of a run have the machine and the line to themselves. */
const AFTER_TICK_MS = 2000;

/** Waits until the robot has driven its first tick or some seconds are over, and the browser is idle. */
export async function whenSettled(run: RunStore): Promise<void> {
  await new Promise<void>((resolve) => {
    const timer = setTimeout(settle, LATEST_MS);
    const end = run.subscribe(({ snapshot }) => {
      if ((snapshot?.tick ?? 0) === 0) return;
      end();
      clearTimeout(timer);
      setTimeout(resolve, AFTER_TICK_MS);
    });
    function settle(): void {
      end();
      resolve();
    }
  });
  await new Promise<void>((resolve) => {
    // Safari does not tell when it is idle.
    if ("requestIdleCallback" in window) requestIdleCallback(() => resolve(), { timeout: 2000 });
    else setTimeout(resolve, 200);
  });
}
