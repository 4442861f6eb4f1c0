/** What the stage's parts share while it is shown: how it is divided, and the square under the pointer. */
import type { Cell } from "@corridor/maze";
import { createStore } from "zustand/vanilla";
import type { Layout } from "../../canvas/viewport.ts";
import type { Tape } from "./tape.ts";

export interface StageView {
  /** null until the stage has been measured */
  layout: Layout | null;
  /** the square that a press would change; null while the pointer is elsewhere or presses */
  hover: Cell | null;
  /** the square that the keyboard stands on; null as long as it is the start */
  cursor: Cell | null;
  /** what is measured; null while nothing is */
  tape: Tape | null;
}

export function createStageView() {
  return createStore<StageView>()(() => ({
    layout: null,
    hover: null,
    cursor: null,
    tape: null,
  }));
}
export type StageViewStore = ReturnType<typeof createStageView>;
