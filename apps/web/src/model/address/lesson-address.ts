/**
 * What is open, in the browser's history: a mission as the fragment of the address, a task of a
 * stored lesson as the state of the history entry, because only this device stores it.
 */
import {
  openTask,
  type ChallengeState,
  type ChallengeStore,
  type TaskPlace,
} from "../challenge/challenge-store.ts";
import { missionHash, missionOfHash } from "./mission-address.ts";

/** The part of the browser that the address bar uses. */
export interface AddressBar {
  location: Pick<Location, "pathname" | "search" | "hash">;
  history: Pick<History, "pushState" | "replaceState" | "state">;
  /** calls back after the student goes back or forward, or types another fragment */
  onMove: (moved: () => void) => void;
}

export function pageAddressBar(): AddressBar {
  return { location, history, onMove: (moved) => window.addEventListener("popstate", moved) };
}

/** What the address opens. */
interface AddressedLessons {
  /** closes the open task when the student goes back to an address without one */
  goHome: () => void;
  /** @returns whether this device still stores the lesson */
  openTaskAt: (place: TaskPlace) => boolean;
}

export class LessonAddress {
  readonly #store: ChallengeStore;
  readonly #bar: AddressBar;
  /**
   * whether the next update is the first of the page; it replaces the history entry, so that Back
   * leads where it did before
   */
  #isFirst = true;
  #isDue = false;

  constructor(store: ChallengeStore, bar: AddressBar, lessons: AddressedLessons) {
    this.#store = store;
    this.#bar = bar;
    store.subscribe((next, before) => {
      const isSame = next.mission === before.mission && isSamePlace(placeOf(next), placeOf(before));
      if (!isSame) this.#followSoon();
    });
    bar.onMove(() => {
      if (bar.location.hash !== "") return;
      const place = placeIn(bar.history.state);
      if (place !== null && lessons.openTaskAt(place)) return;
      const { mission, lessonId } = store.getState();
      if (mission !== null || lessonId !== null) lessons.goHome();
    });
  }

  /** Call it before a task opens, so that Back leads to what is open now. */
  opening(): void {
    this.#isFirst = false;
  }

  /**
   * Switching tasks closes the first and opens the second. The microtask merges both changes into one
   * history entry.
   */
  #followSoon(): void {
    if (this.#isDue) return;
    this.#isDue = true;
    queueMicrotask(() => {
      this.#isDue = false;
      this.#follow();
    });
  }

  #follow(): void {
    const { location, history } = this.#bar;
    const { pathname, search } = location;
    const state = this.#store.getState();
    const { mission } = state;
    const place = placeOf(state);
    const hash = mission === null ? "" : missionHash(mission);
    const isFirst = this.#isFirst;
    this.#isFirst = false;
    if (location.hash === hash && isSamePlace(placeIn(history.state), place)) return;
    // The code that opens a link removes the link from the address.
    const isOther =
      (location.hash !== "" && missionOfHash(location.hash) === null) || pathname.startsWith("/m/");
    if (mission === null && isOther) {
      if (place !== null) history.replaceState({ task: place }, "", addressOf(location));
      return;
    }
    if (mission !== null && isFirst && location.hash !== "") return;
    const entry = place && { task: place };
    const address = pathname + search + hash;
    if (isFirst) history.replaceState(entry, "", address);
    else history.pushState(entry, "", address);
  }
}

function addressOf({ pathname, search, hash }: AddressBar["location"]): string {
  return pathname + search + hash;
}

/** The open task of a stored lesson; null if none is open. */
function placeOf(state: ChallengeState): TaskPlace | null {
  const { lessonId: lesson, index } = state;
  return lesson === null || openTask(state) === null ? null : { lesson, index };
}

function placeIn(state: unknown): TaskPlace | null {
  if (typeof state !== "object" || state === null || !("task" in state)) return null;
  const { task } = state;
  if (typeof task !== "object" || task === null) return null;
  const { lesson, index } = task as Record<string, unknown>;
  return typeof lesson === "string" && typeof index === "number" ? { lesson, index } : null;
}

function isSamePlace(one: TaskPlace | null, other: TaskPlace | null): boolean {
  return one?.lesson === other?.lesson && one?.index === other?.index;
}
