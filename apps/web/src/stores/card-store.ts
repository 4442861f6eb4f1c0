/**
 * What there is to explain: the newest bump of the program, and the goal. A card belongs to a moment of
 * the run; whether it shows is seen from the moment on the screen.
 */
import type { Mend } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import { createStore } from "zustand/vanilla";
import type { Moment } from "../worker/worker-messages.ts";

export interface Explanation {
  moment: Moment;
  /** the program that drove */
  program: ProgramDocument;
  /** edits that would have kept the robot from this bump, each tried; none for a goal */
  mends: readonly Mend[];
}

export interface CardState {
  bump: Explanation | null;
  goal: Explanation | null;
}

export function createCardStore() {
  return createStore<CardState>()(() => ({ bump: null, goal: null }));
}
export type CardStore = ReturnType<typeof createCardStore>;

/**
 * Keeps a moment that has a card: the goal, and a bump for which the run has paused.
 * @param newest the program that stands on the page, which may have been edited in the same moment
 */
export function explain(store: CardStore, moment: Moment, newest: ProgramDocument): void {
  const { kind, mends } = moment;
  const drove = moment.program ?? newest;
  // What is equal is the page's own, so that an edit from here on is seen by the object.
  const program = JSON.stringify(drove) === JSON.stringify(newest) ? newest : drove;
  if (kind === "goal") store.setState({ goal: { moment, program, mends: [] } });
  else if (mends !== null) store.setState({ bump: { moment, program, mends } });
}

/** The run no longer goes further than to this tick: what came after it has not happened. */
export function forgetAfter(store: CardStore, tick: number): void {
  const kept = (each: Explanation | null) =>
    each !== null && each.moment.tick <= tick ? each : null;
  const { bump, goal } = store.getState();
  store.setState({ bump: kept(bump), goal: kept(goal) });
}
