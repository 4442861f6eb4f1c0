/** State that the parts of the stage share: the layout, and the squares of pointer and keyboard. */
import type { Cell } from "@corridor/maze";
import { createStore } from "zustand/vanilla";
import type { Layout, Scroll } from "../drawing/viewport.ts";
import type { Zoom } from "./stage-layout.ts";
import type { Tape } from "./tape.ts";

export interface StageView {
  /** null until the stage has been measured */
  layout: Layout | null;
  /** the position of the visible part, in this layout */
  scroll: Scroll;
  /** number of handled scroll requests of the painter */
  answers: number;
  /** the zoom that the user has chosen */
  zoom: Zoom;
  /** the square that a press would change; null while the pointer is elsewhere or pressed */
  hover: Cell | null;
  /** the square of the keyboard's cursor; null while it is the start */
  cursor: Cell | null;
  /** the measuring tape; null if there is none */
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
