/**
 * Which drive keys are held down, and what that asks of the robot. The key pressed last wins; letting
 * go of it returns to the one still held; letting go of all stops. At the goal what is held has done its
 * work, and drives again once it is let go and pressed anew. React-free; buttons, the keyboard and
 * fingers all end here.
 */
import { createStore } from "zustand/vanilla";
import type { DriveKey } from "../../worker/worker-messages.ts";

interface Held {
  /** what holds it: a key of the keyboard or a pointer; the same key may be held by two */
  source: string;
  key: DriveKey;
  /** still down, as a keyboard that repeats it goes on to say, but it counts for nothing any more */
  isSpent?: true;
}

export interface HoldState {
  /** in the order of their presses */
  held: readonly Held[];
}

/** The key that counts: the one pressed last; null when none is held. */
export function activeKey(state: HoldState): DriveKey | null {
  return state.held.findLast(({ isSpent }) => isSpent !== true)?.key ?? null;
}

/** Whether one source holds a key that counts. */
export function isHeldBy(state: HoldState, source: string): boolean {
  return state.held.some((each) => each.source === source && each.isSpent !== true);
}

/**
 * @param send receives each change of the key that counts; "stop" when none is held any more
 * @param mayPress asked before each press; false: the press counts for nothing
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

    /** A key goes down. Repeats of a held key (as keyboards send them) change nothing. */
    press: (source: string, key: DriveKey): void => {
      const { held } = store.getState();
      if (held.some((each) => each.source === source) || !mayPress(key)) return;
      change([...held, { source, key }]);
    },

    /** A key goes up. */
    release: (source: string): void => {
      const { held } = store.getState();
      if (held.some((each) => each.source === source)) {
        change(held.filter((each) => each.source !== source));
      }
    },

    /** Nobody can be sure of a release any more (the window or the field lost its focus): stop. */
    releaseAll: (): void => change([]),

    /** The robot is where it was driven to: stop, and wait for a new press. */
    arrive: (): void => change(store.getState().held.map((each) => ({ ...each, isSpent: true }))),

    /** Another driver took over: keys still held count for nothing, and nothing is sent. */
    forget: (): void => store.setState({ held: [] }),
  };
}
export type HoldStore = ReturnType<typeof createHoldStore>;
