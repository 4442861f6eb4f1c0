/** What the stage's parts share while it is shown: how it is divided, and the square under the pointer. */
import type { Cell } from "@corridor/maze";
import { createStore } from "zustand/vanilla";
import type { Layout, Scroll } from "../../canvas/viewport.ts";
import type { Zoom } from "./stage-layout.ts";
import type { Tape } from "./tape.ts";

export interface StageView {
  /** null until the stage has been measured */
  layout: Layout | null;
  /** which part shows of a maze that is larger than the stage; of this layout */
  scroll: Scroll;
  /** how many of the painter's requests to scroll were handled */
  answers: number;
  /** what the reader chose */
  zoom: Zoom;
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
    scroll: { x: 0, y: 0 },
    answers: 0,
    zoom: null,
    hover: null,
    cursor: null,
    tape: null,
  }));
}
export type StageViewStore = ReturnType<typeof createStageView>;
