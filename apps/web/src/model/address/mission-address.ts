/**
 * The address of a mission or a bonus mission: `#mission/side-opening`. A fragment works on any
 * static host, offline and below every path (docs/adr/0015-mission-urls-as-fragments.md).
 */
import type { ChallengeStore } from "../challenge/challenge-store.ts";

const PREFIX = "#mission/";

/** The fragment of a mission's address. */
export function missionHash(id: string): string {
  return PREFIX + id;
}

/** The mission that a fragment names, whether or not it exists; null for any other fragment. */
export function missionOfHash(hash: string): string | null {
  return hash.startsWith(PREFIX) ? hash.slice(PREFIX.length) : null;
}

/** The part of the browser that the address bar uses. */
export interface AddressBar {
  location: Pick<Location, "pathname" | "search" | "hash">;
  history: Pick<History, "pushState" | "replaceState">;
  /** calls back after the student goes back or forward, or types another fragment */
  onMove: (moved: () => void) => void;
}

export function pageAddressBar(): AddressBar {
  return { location, history, onMove: (moved) => window.addEventListener("popstate", moved) };
}

export class MissionAddress {
  readonly #store: ChallengeStore;
  readonly #bar: AddressBar;
  /**
   * whether the next update is the first of the page; it replaces the history entry, so that Back
   * leads where it did before
   */
  #isFirst = true;
  #isDue = false;

  /** @param goHome closes the open mission when the student goes back to an address without one */
  constructor(store: ChallengeStore, bar: AddressBar, goHome: () => void) {
    this.#store = store;
    this.#bar = bar;
    store.subscribe((next, before) => {
      if (next.mission !== before.mission) this.#followSoon();
    });
    bar.onMove(() => {
      const isPlain = bar.location.hash === "";
      if (isPlain && store.getState().mission !== null) goHome();
    });
  }

  /** Call it before a mission opens, so that Back leads to what is open now. */
  opening(): void {
    this.#isFirst = false;
  }

  /**
   * Switching missions closes the first and opens the second. The microtask merges both changes
   * into one history entry.
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
    const { mission } = this.#store.getState();
    const hash = mission === null ? "" : missionHash(mission);
    const isFirst = this.#isFirst;
    this.#isFirst = false;
    if (location.hash === hash) return;
    // The code that opens a link removes the link from the address.
    const isOther = location.hash !== "" && missionOfHash(location.hash) === null;
    if (mission === null ? isOther : isFirst && location.hash !== "") return;
    const address = location.pathname + location.search + hash;
    if (isFirst) history.replaceState(null, "", address);
    else history.pushState(null, "", address);
  }
}
