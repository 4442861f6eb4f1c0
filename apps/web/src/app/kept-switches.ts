/** Keeps on the device what its reader has switched off: keys without Ctrl, the spoken run. */
import type { ScreenState, ScreenStore } from "../stores/screen-store.ts";
import type { KeyValueStorage } from "./works.ts";

const keys = {
  singleKeys: "corridor.single-keys",
  speakRun: "corridor.speak-run",
} as const satisfies Partial<Record<keyof ScreenState, string>>;

/** Reads the kept choices, then follows the switches. */
export function keepSwitches(screen: ScreenStore, storage: KeyValueStorage): void {
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
