/**
 * The run as one line of the program follows it. A program may have 200 lines, of which a screen shows
 * ten: those in sight hear all news; while the robot runs, the others hear every fourth, in turns, so that
 * what a screen reader finds there is a second old at most. When the robot rests, all lines are exact.
 */
import type { RunState } from "../../stores/run-store.ts";
import type { StateSource } from "../../ui/follow-text.ts";

/** News come four times a second. */
const TURNS = 4;

export interface LineFeed extends StateSource<RunState> {
  /**
   * Follows whether the browser draws the line, which it says of elements with `content-visibility: auto`;
   * where it never says so, the line counts as in sight.
   * @returns a function that ends it
   */
  watch: (line: EventTarget) => () => void;
}

/** @param index any number; lines with neighbouring ones have their turns one after the other */
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
    watch(line) {
      const look = (event: Event): void => {
        // What lies in the line may be left out as well.
        if (event.target === line && "skipped" in event) isOutOfSight = event.skipped === true;
      };
      line.addEventListener("contentvisibilityautostatechange", look);
      return () => line.removeEventListener("contentvisibilityautostatechange", look);
    },
  };
}
