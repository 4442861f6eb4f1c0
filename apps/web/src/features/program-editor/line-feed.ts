/**
 * The run as one line of the program follows it. A program may have 200 lines, and a screen shows
 * about ten. Lines in sight receive every update. While the robot runs, the others receive every
 * fourth one, in turns. Screen readers thus read values at most one second old. When the robot
 * stops, all lines are exact.
 */
import type { RunState } from "../../model/run/run-store.ts";
import type { StateSource } from "../../ui/follow-text.ts";

/** Lines out of sight receive every fourth update. Updates arrive four times a second. */
const TURNS = 4;

export interface LineFeed extends StateSource<RunState> {
  /**
   * Observes whether the browser renders the line. Browsers report it for elements with
   * `content-visibility: auto`. Without a report, the line counts as in sight.
   * @returns a function that stops observing
   */
  observe: (line: EventTarget) => () => void;
}

/** @param index any number; lines with neighbouring numbers take their turns one after the other */
export function lineFeed(run: StateSource<RunState>, index: number): LineFeed {
  let isOutOfSight = false;
  return {
    getState: run.getState,
    subscribe(listener) {
      let turn = index;
      return run.subscribe((state) => {
        turn += 1;
        const mayWait = isOutOfSight && state.snapshot?.state === "running";
        if (!mayWait || turn % TURNS === 0) listener(state);
      });
    },
    observe(line) {
      const look = (event: Event): void => {
        // Elements inside the line may skip rendering as well.
        if (event.target === line && "skipped" in event) isOutOfSight = event.skipped === true;
      };
      line.addEventListener("contentvisibilityautostatechange", look);
      return () => line.removeEventListener("contentvisibilityautostatechange", look);
    },
  };
}
