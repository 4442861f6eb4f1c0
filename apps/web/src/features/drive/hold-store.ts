/**
 * Which drive keys are held, and which of them drives the robot. The newest press wins; its release
 * returns to a key that is still held; the last release stops. At the goal, all held keys are
 * spent: they drive again after a release and a new press. Independent of React; buttons, keyboard
 * and touch use it.
 */
import { createStore } from "zustand/vanilla";
import type { DriveKey } from "../../simulator/protocol/worker-messages.ts";

interface Held {
  /**
   * the key of the keyboard or the pointer that holds the key; two sources may hold the same key
   */
  source: string;
  key: DriveKey;
  /** still down, and repeated by the keyboard, but without effect */
  isSpent?: true;
}

export interface HoldState {
  /** in the order of the presses */
  held: readonly Held[];
}

/** The active key: the newest press that is not spent; null if there is none. */
export function activeKey(state: HoldState): DriveKey | null {
  return state.held.findLast(({ isSpent }) => isSpent !== true)?.key ?? null;
}

/** Whether a source holds a key that is not spent. */
export function isHeldBy(state: HoldState, source: string): boolean {
  return state.held.some((each) => each.source === source && each.isSpent !== true);
}

/**
 * @param send receives each change of the active key; "stop" if no key is active any more
 * @param mayPress called before each press; false rejects the press
 */
export function createHoldStore(
  send: (key: DriveKey) => void,
  mayPress: (key: DriveKey) => boolean = () => true,
) {
  const store = createStore<HoldState>()(() => ({ held: [] }));

  function change(held: readonly Held[]): void {
    const before = activeKey(store.getState());
    store.setState({ held });
    const after = activeKey({ held });
    if (after !== before) send(after ?? "stop");
  }

  return {
    ...store,

    /** Presses a key. Repeats of a held key, as keyboards send them, change nothing. */
    press: (source: string, key: DriveKey): void => {
      const { held } = store.getState();
      if (held.some((each) => each.source === source) || !mayPress(key)) return;
      change([...held, { source, key }]);
    },

    /** Releases a key. */
    release: (source: string): void => {
      const { held } = store.getState();
      if (held.some((each) => each.source === source)) {
        change(held.filter((each) => each.source !== source));
      }
    },

    /**
     * Releases all keys and stops. A release may be missed after the window lost the focus, or a
     * field received it.
     */
    releaseAll: (): void => change([]),

    /** The robot has reached the goal: stops, and waits for a new press. */
    arrive: (): void => change(store.getState().held.map((each) => ({ ...each, isSpent: true }))),

    /** Another driver took over: releases all keys and sends nothing. */
    clear: (): void => store.setState({ held: [] }),
  };
}
export type HoldStore = ReturnType<typeof createHoldStore>;
