/** Keeps on the device whether keys without Ctrl work, for those whom they get in the way. */
import type { ScreenStore } from "../stores/screen-store.ts";
import type { KeyValueStorage } from "./works.ts";

const SINGLE_KEYS_KEY = "corridor.single-keys";

/** Reads the kept choice, then follows the switch. */
export function keepSingleKeys(screen: ScreenStore, storage: KeyValueStorage): void {
  if (storage.getItem(SINGLE_KEYS_KEY) === "off") screen.setState({ singleKeys: false });
  screen.subscribe(({ singleKeys }, before) => {
    if (singleKeys === before.singleKeys) return;
    try {
      storage.setItem(SINGLE_KEYS_KEY, singleKeys ? "on" : "off");
    } catch {
      // The choice then lasts until the page is left.
    }
  });
}
