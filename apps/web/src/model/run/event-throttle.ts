/**
 * Throttles bumps and goals to a rate that people and screen readers can follow. At the highest
 * speed a robot bumps more than a hundred times a second, and each displayed bump rewrites a live
 * region.
 */
import type { RunEvent } from "../../simulator/protocol/worker-messages.ts";

/** Least time between two displayed bumps. */
const BUMP_INTERVAL_MS = 500;

export interface EventThrottlePorts {
  /** displays an event, or none */
  show: (event: RunEvent | null) => void;
  /** monotonic milliseconds */
  now: () => number;
  /** calls a function later, such as `setTimeout` */
  later: (run: () => void, milliseconds: number) => void;
}

export interface EventThrottle {
  /** shows a goal at once, and a bump when it is due unless a newer event replaces it */
  push: (event: RunEvent) => void;
  /** discards events after this tick (-1: all); the next event is shown at once */
  truncate: (tick: number) => void;
}

/** Creates a throttle. The newest event is always the one that stays on the screen. */
export function createEventThrottle({ show, now, later }: EventThrottlePorts): EventThrottle {
  let pending: RunEvent | null = null;
  let shown: RunEvent | null = null;
  let shownAt = Number.NEGATIVE_INFINITY;
  let hasTimer = false;

  function showNow(event: RunEvent): void {
    pending = null;
    shown = event;
    shownAt = now();
    show(event);
  }

  /** A timer may fire for a bump that was shown or discarded, or before a later one is due. */
  function showWhenDue(): void {
    if (pending === null) return;
    const rest = shownAt + BUMP_INTERVAL_MS - now();
    if (rest <= 0) {
      showNow(pending);
      return;
    }
    if (hasTimer) return;
    hasTimer = true;
    later(() => {
      hasTimer = false;
      showWhenDue();
    }, rest);
  }

  return {
    push: (event) => {
      if (event.kind === "goal") {
        showNow(event);
        return;
      }
      pending = event;
      showWhenDue();
    },
    truncate: (tick) => {
      if (pending !== null && pending.tick > tick) pending = null;
      if (shown === null || shown.tick <= tick) return;
      shown = null;
      shownAt = Number.NEGATIVE_INFINITY;
      show(null);
    },
  };
}
