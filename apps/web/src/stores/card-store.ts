/**
 * What there is to explain: the newest bump of a program or a script, and the goal. A card belongs to a moment of
 * the run; whether it shows is seen from the moment on the screen.
 */
import type { Diagnosis } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import { createStore } from "zustand/vanilla";
import type { Moment } from "../worker/worker-messages.ts";

export interface Explanation {
  moment: Moment;
  /** the program that drove */
  program: ProgramDocument;
  /** why the robot bumped; null for the goal */
  diagnosis: Diagnosis | null;
}

export interface CardState {
  bump: Explanation | null;
  goal: Explanation | null;
}

export function createCardStore() {
  return createStore<CardState>()(() => ({ bump: null, goal: null }));
}
export type CardStore = ReturnType<typeof createCardStore>;

/** Where a card stands that has no place beside the robot: at the upper end of the panel or the sheet. */
export interface CardDockState {
  /** null before there is one */
  element: HTMLElement | null;
  /** how far a sheet has to be open for the card that stands there; null while none does */
  need: "half" | "more" | null;
}

export function createCardDock() {
  return createStore<CardDockState>()(() => ({ element: null, need: null }));
}

/**
 * Keeps a moment that has a card: the goal, and a bump for which the run has paused.
 * @param newest the program that stands on the page, which may have been edited in the same moment
 */
export function explain(store: CardStore, moment: Moment, newest: ProgramDocument): void {
  const { kind, diagnosis } = moment;
  const drove = moment.program ?? newest;
  // What is equal is the page's own, so that an edit from here on is seen by the object.
  const program = JSON.stringify(drove) === JSON.stringify(newest) ? newest : drove;
  if (kind === "goal") store.setState({ goal: { moment, program, diagnosis } });
  else if (diagnosis !== null) store.setState({ bump: { moment, program, diagnosis } });
}

/** The run no longer goes further than to this tick: what came after it has not happened. */
export function forgetAfter(store: CardStore, tick: number): void {
  const kept = (each: Explanation | null) =>
    each !== null && each.moment.tick <= tick ? each : null;
  const { bump, goal } = store.getState();
  store.setState({ bump: kept(bump), goal: kept(goal) });
}
export type CardDock = ReturnType<typeof createCardDock>;
