/**
 * The scroll position of the stage. The view store owns it, together with the layout: the painter,
 * the grid and the pointer use both. The page's scroll container follows a new layout as soon as it
 * has the layout's sizes. It leads when the user scrolls.
 *
 * A scroll event is not enough to synchronize them. A container that no longer scrolls moves to 0
 * without an event. A container that scrolls again can start at its earlier position.
 */
import { clampScroll, type Layout, type Scroll } from "../drawing/viewport.ts";
import { isSameStageLayout } from "./same-stage-layout.ts";
import type { StageViewStore } from "./stage-view.ts";

/** The part of a scroll container that is used here. */
export type ScrollBox = Pick<HTMLElement, "scrollLeft" | "scrollTop"> & {
  scrollTo(options: ScrollToOptions): void;
};

/**
 * Sets the layout and clamps the scroll position to it.
 * @returns false for an equal layout, which changes nothing
 */
export function setLayout(view: StageViewStore, layout: Layout): boolean {
  const { layout: before, scroll } = view.getState();
  if (before !== null && isSameStageLayout(before, layout)) return false;
  view.setState({ layout, scroll: clampScroll(layout, scroll) });
  return true;
}

/** Scrolls the container to the stored position, once it has the layout's sizes. */
export function applyScroll(view: StageViewStore, box: ScrollBox): void {
  const { scroll } = view.getState();
  box.scrollTo({ left: scroll.x, top: scroll.y, behavior: "instant" });
  readScroll(view, box);
}

/** Stores the container's scroll position. */
export function readScroll(view: StageViewStore, box: ScrollBox): void {
  const { layout, scroll } = view.getState();
  if (layout === null) return;
  const next = clampScroll(layout, { x: box.scrollLeft, y: box.scrollTop });
  if (next.x !== scroll.x || next.y !== scroll.y) view.setState({ scroll: next });
}

/**
 * Scrolls on the painter's request. The request counts as handled even if nothing moves, so that
 * the painter can send another one.
 */
export function followRequest(view: StageViewStore, box: ScrollBox, scroll: Scroll): void {
  const { layout, answers } = view.getState();
  if (layout === null) return;
  view.setState({ scroll: clampScroll(layout, scroll), answers: answers + 1 });
  applyScroll(view, box);
}

/** Scrolls to the part that the user selects on the small map. */
export function moveScroll(view: StageViewStore, box: ScrollBox, scroll: Scroll): void {
  const { layout } = view.getState();
  if (layout === null) return;
  view.setState({ scroll: clampScroll(layout, scroll) });
  applyScroll(view, box);
}
