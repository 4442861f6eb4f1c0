/**
 * Explanations: the newest bump of a program or a script, and the goal. A card belongs to a tick of
 * the run; it shows only while that tick is displayed.
 */
import type { Diagnosis } from "@corridor/coach";
import { isSameProgram, type ProgramDocument } from "@corridor/program";
import { createStore } from "zustand/vanilla";
import type { RunEvent } from "../../simulator/protocol/worker-messages.ts";

export interface Explanation {
  event: RunEvent;
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

/**
 * Place for a card that does not fit beside the robot: at the upper end of the panel or the sheet.
 */
export interface CardDockState {
  /** null before it is mounted */
  element: HTMLElement | null;
  /** how far a sheet has to be open for the docked card; null without one */
  need: "half" | "more" | null;
  /** whether the card of a bump explains the failed run, in the dock or beside the robot */
  hasBump: boolean;
  /** whether the docked card states the open task, too */
  hasTask: boolean;
}

export function createCardDock() {
  return createStore<CardDockState>()(() => ({
    element: null,
    need: null,
    hasBump: false,
    hasTask: false,
  }));
}

/**
 * Stores an event that has a card: the goal, or a bump that paused the run.
 * @param newest the program of the page, which may have been edited since the event
 */
export function explain(store: CardStore, event: RunEvent, newest: ProgramDocument): void {
  const { kind, diagnosis } = event;
  const drove = event.program ?? newest;
  // An equal program is replaced by the page's own object, so that an edit shows by its identity.
  const program = isSameProgram(drove, newest) ? newest : drove;
  if (kind === "goal") store.setState({ goal: { event, program, diagnosis } });
  else if (diagnosis !== null) store.setState({ bump: { event, program, diagnosis } });
}

/** Discards explanations after this tick, at which the run now ends. */
export function truncateCards(store: CardStore, tick: number): void {
  const retained = (each: Explanation | null) =>
    each !== null && each.event.tick <= tick ? each : null;
  const { bump, goal } = store.getState();
  store.setState({ bump: retained(bump), goal: retained(goal) });
}
export type CardDock = ReturnType<typeof createCardDock>;
