/**
 * Light, dark, or as the system is. The choice is kept on the device; `public/theme.js` applies it
 * before the first paint, so that the page never flashes in the other one.
 */
import type { ScreenStore, Theme } from "../stores/screen-store.ts";
import type { KeyValueStorage } from "./works.ts";

/** Also read by `public/theme.js`. */
const THEME_KEY = "corridor.theme";

const themes: readonly Theme[] = ["system", "light", "dark"];

export interface ThemePorts {
  screen: ScreenStore;
  storage: KeyValueStorage;
  /** the media query "(prefers-color-scheme: dark)" */
  systemDark: {
    readonly matches: boolean;
    addEventListener: (type: "change", listener: () => void) => void;
  };
  /** shows it: sets data-theme on the document's root */
  apply: (shown: "light" | "dark") => void;
}

/** Reads the kept choice, then follows the reader's and the system's changes. */
export function startTheme({ screen, storage, systemDark, apply }: ThemePorts): void {
  const kept = themes.find((theme) => theme === storage.getItem(THEME_KEY));
  if (kept !== undefined) screen.setState({ theme: kept });

  function show(): void {
    const { theme } = screen.getState();
    apply(theme === "system" ? (systemDark.matches ? "dark" : "light") : theme);
  }
  show();
  systemDark.addEventListener("change", show);
  screen.subscribe((next, before) => {
    if (next.theme === before.theme) return;
    show();
    try {
      storage.setItem(THEME_KEY, next.theme);
    } catch {
      // The choice then lasts until the page is left.
    }
  });
}
