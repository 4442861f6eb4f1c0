/**
 * Light, dark, or as the system; with more contrast, or as the system. The choices are stored on
 * the device; `public/first.js` applies them before the first paint, so that the page never flashes
 * in other colours.
 */
import type { ScreenStore, Theme } from "../screen/screen-store.ts";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";

/** Also read by `public/first.js`. */
const THEME_KEY = "corridor.theme";
const CONTRAST_KEY = "corridor.contrast";

const themes: readonly Theme[] = ["system", "light", "dark"];

/** The part of a MediaQueryList that is used. */
interface MediaQuery {
  readonly matches: boolean;
  addEventListener: (type: "change", listener: () => void) => void;
}

export interface ResolvedTheme {
  theme: "light" | "dark";
  contrast: "normal" | "more";
}

export interface ThemePorts {
  screen: ScreenStore;
  storage: KeyValueStorage;
  /** the media query "(prefers-color-scheme: dark)" */
  systemDark: MediaQuery;
  /** the media query "(prefers-contrast: more)" */
  systemContrast: MediaQuery;
  /** sets data-theme and data-contrast on the document's root */
  apply: (shown: ResolvedTheme) => void;
}

/** Reads the stored choices, then follows changes of the user and of the system. */
export function startTheme(ports: ThemePorts): void {
  const { screen, storage, systemDark, systemContrast, apply } = ports;
  const stored = themes.find((theme) => theme === storage.getItem(THEME_KEY));
  if (stored !== undefined) screen.setState({ theme: stored });
  if (storage.getItem(CONTRAST_KEY) === "more") screen.setState({ contrast: "more" });

  function show(): void {
    const { theme, contrast } = screen.getState();
    apply({
      theme: theme === "system" ? (systemDark.matches ? "dark" : "light") : theme,
      contrast: contrast === "more" || systemContrast.matches ? "more" : "normal",
    });
  }
  show();
  systemDark.addEventListener("change", show);
  systemContrast.addEventListener("change", show);
  screen.subscribe((next, before) => {
    if (next.theme === before.theme && next.contrast === before.contrast) return;
    show();
    try {
      storage.setItem(THEME_KEY, next.theme);
      storage.setItem(CONTRAST_KEY, next.contrast);
    } catch {
      // The choice then lasts until the page is left.
    }
  });
}
