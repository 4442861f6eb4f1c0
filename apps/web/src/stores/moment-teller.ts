/**
 * Tells bumps and goals at a pace that people and screen readers can follow. At the highest speed a
 * robot bumps more than a hundred times a second, and each one told rewrites a live region.
 */
import type { Moment } from "../worker/worker-messages.ts";

/** A bump is told at most twice a second. */
const BUMP_INTERVAL_MS = 500;

export interface MomentPorts {
  /** puts a moment, or that there is none, on the screen */
  show: (moment: Moment | null) => void;
  /** milliseconds since any fixed time */
  now: () => number;
  /** runs a function later, such as `setTimeout` */
  later: (run: () => void, milliseconds: number) => void;
}

export interface MomentTeller {
  /** tells a goal at once, and a bump when its turn comes unless something newer is told instead */
  tell: (moment: Moment) => void;
  /** what came after the end of a tick has not happened (-1: nothing has), and the next is told at once */
  forgetAfter: (tick: number) => void;
}

/** Makes a teller; the newest moment is always the one that stays. */
export function createMomentTeller({ show, now, later }: MomentPorts): MomentTeller {
  let waiting: Moment | null = null;
  let told: Moment | null = null;
  let toldAt = Number.NEGATIVE_INFINITY;
  let isTimed = false;

  function tellNow(moment: Moment): void {
    waiting = null;
    told = moment;
    toldAt = now();
    show(moment);
  }

  /** A timer may ring for a bump that was told or cleared, or before the turn of a later one. */
  function tellWhenDue(): void {
    if (waiting === null) return;
    const rest = toldAt + BUMP_INTERVAL_MS - now();
    if (rest <= 0) {
      tellNow(waiting);
      return;
    }
    if (isTimed) return;
    isTimed = true;
    later(() => {
      isTimed = false;
      tellWhenDue();
    }, rest);
  }

  return {
    tell: (moment) => {
      if (moment.kind === "goal") {
        tellNow(moment);
        return;
      }
      waiting = moment;
      tellWhenDue();
    },
    forgetAfter: (tick) => {
      if (waiting !== null && waiting.tick > tick) waiting = null;
      if (told === null || told.tick <= tick) return;
      told = null;
      toldAt = Number.NEGATIVE_INFINITY;
      show(null);
    },
  };
}
