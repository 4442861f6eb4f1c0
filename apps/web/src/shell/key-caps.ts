/** Labels of keys: "Ctrl" is "Strg" on a German keyboard, and ⌘ on a Mac. */
import type { TFunction } from "i18next";

const worded = {
  Space: "spaceBar",
  Esc: "escape",
  Ctrl: "control",
  Shift: "shift",
  Alt: "alt",
  Tab: "tab",
  Enter: "enter",
  Delete: "delete",
  Home: "home",
  End: "end",
  "Page Up": "pageUp",
  "Page Down": "pageDown",
} as const;

/** Symbols on a Mac's keyboard in every language. */
const macSigns: Readonly<Record<string, string>> = {
  Ctrl: "⌘",
  Shift: "⇧",
  Alt: "⌥",
  Delete: "⌦",
};

/**
 * @param keys "Ctrl+Shift+Z": a plus joins keys that are pressed together; letters, symbols and
 *   arrows are the same everywhere
 */
export function capsOf(t: TFunction, keys: string, isMac: boolean): string {
  return keys
    .split("+")
    .map((key) => (isMac ? macSigns[key] : undefined) ?? capOf(t, key))
    .join("+");
}

function capOf(t: TFunction, key: string): string {
  return key in worded ? t(`drive.cap.${worded[key as keyof typeof worded]}`) : key;
}
