/** Stores the switches of single-key shortcuts and spoken messages on the device. */
import type { ScreenState, ScreenStore } from "../screen/screen-store.ts";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";

const keys = {
  singleKeys: "corridor.single-keys",
  speakRun: "corridor.speak-run",
} as const satisfies Partial<Record<keyof ScreenState, string>>;

/** Reads the stored switches, then stores changes. */
export function storeSwitches(screen: ScreenStore, storage: KeyValueStorage): void {
  for (const name of ["singleKeys", "speakRun"] as const) {
    if (storage.getItem(keys[name]) === "off") screen.setState({ [name]: false });
    screen.subscribe((state, before) => {
      if (state[name] === before[name]) return;
      try {
        storage.setItem(keys[name], state[name] ? "on" : "off");
      } catch {
        // The choice then lasts until the page is left.
      }
    });
  }
}
