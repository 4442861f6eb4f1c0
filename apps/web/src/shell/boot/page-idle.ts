/** Waits until the page has time for work that is not visible yet. */
import type { RunStore } from "../../model/run/run-store.ts";

/** Users who do not press Run at once look around first. */
const LATEST_MS = 5000;
/** The first seconds of a run have CPU and network to themselves. */
const AFTER_TICK_MS = 2000;

/** Resolves after the robot's first tick or some seconds, when the browser is idle. */
export async function whenIdle(run: RunStore): Promise<void> {
  await new Promise<void>((resolve) => {
    const timer = setTimeout(finish, LATEST_MS);
    const end = run.subscribe(({ snapshot }) => {
      if ((snapshot?.tick ?? 0) === 0) return;
      end();
      clearTimeout(timer);
      setTimeout(resolve, AFTER_TICK_MS);
    });
    function finish(): void {
      end();
      resolve();
    }
  });
  await new Promise<void>((resolve) => {
    // Safari has no requestIdleCallback.
    if ("requestIdleCallback" in window) requestIdleCallback(() => resolve(), { timeout: 2000 });
    else setTimeout(resolve, 200);
  });
}
