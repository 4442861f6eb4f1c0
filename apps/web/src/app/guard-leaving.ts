/**
 * Asks before the page is left while the device does not keep the newest edits: closing the tab, a
 * reload, another address. Only then, since a page that asks cannot be put aside and brought back.
 */
import type { ScreenStore } from "../stores/screen-store.ts";

interface Leaving {
  addEventListener(type: "beforeunload", ask: (event: Event) => void): void;
  removeEventListener(type: "beforeunload", ask: (event: Event) => void): void;
}

export function guardLeaving(screen: ScreenStore, page: Leaving): void {
  // The browser asks in its own words.
  const ask = (event: Event): void => event.preventDefault();
  screen.subscribe(({ saved }, before) => {
    if ((saved === "blocked") === (before.saved === "blocked")) return;
    if (saved === "blocked") page.addEventListener("beforeunload", ask);
    else page.removeEventListener("beforeunload", ask);
  });
}
