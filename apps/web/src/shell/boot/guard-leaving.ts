/**
 * Asks before the page is left while the newest edits are not stored: closing the tab, a reload,
 * another address. Only then, because a page with this listener cannot enter the back/forward
 * cache.
 */
import type { ScreenStore } from "../../model/screen/screen-store.ts";

interface Leaving {
  addEventListener(type: "beforeunload", ask: (event: Event) => void): void;
  removeEventListener(type: "beforeunload", ask: (event: Event) => void): void;
}

export function guardLeaving(screen: ScreenStore, page: Leaving): void {
  // The browser shows its own text.
  const ask = (event: Event): void => event.preventDefault();
  screen.subscribe(({ saved }, before) => {
    if ((saved === "blocked") === (before.saved === "blocked")) return;
    if (saved === "blocked") page.addEventListener("beforeunload", ask);
    else page.removeEventListener("beforeunload", ask);
  });
}
