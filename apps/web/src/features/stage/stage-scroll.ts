/**
 * The scroll position of the stage. The view store owns it, together with the layout: the painter, the grid
 * and the pointer all use these two. The page's scroll container follows a new layout as soon as it has the
 * layout's sizes, and leads when the reader scrolls.
 *
 * A scroll event is not enough to keep them in step: a container that no longer scrolls goes to 0
 * without one, and a container that scrolls again may start where it was left.
 */
import { clampScroll, type Layout, type Scroll } from "../../canvas/viewport.ts";
import type { StageViewStore } from "./stage-view.ts";

/** As much of a scroll container as is needed here. */
export type ScrollBox = Pick<HTMLElement, "scrollLeft" | "scrollTop"> & {
  scrollTo(options: ScrollToOptions): void;
};

/** Divides the stage anew; the scroll position moves into what the layout can show. */
export function setLayout(view: StageViewStore, layout: Layout): void {
  view.setState({ layout, scroll: clampScroll(layout, view.getState().scroll) });
}

/** Brings the container to the stored position, once it has the layout's sizes. */
export function applyScroll(view: StageViewStore, box: ScrollBox): void {
  const { scroll } = view.getState();
  box.scrollTo({ left: scroll.x, top: scroll.y, behavior: "instant" });
  readScroll(view, box);
}

/** Stores the container's position. */
export function readScroll(view: StageViewStore, box: ScrollBox): void {
  const { layout, scroll } = view.getState();
  if (layout === null) return;
  const next = clampScroll(layout, { x: box.scrollLeft, y: box.scrollTop });
  if (next.x !== scroll.x || next.y !== scroll.y) view.setState({ scroll: next });
}

/** Scrolls on the painter's request. It is answered even where nothing moves, so that it can ask again. */
export function followRequest(view: StageViewStore, box: ScrollBox, scroll: Scroll): void {
  const { layout, answers } = view.getState();
  if (layout === null) return;
  view.setState({ scroll: clampScroll(layout, scroll), answers: answers + 1 });
  applyScroll(view, box);
}

/** Scrolls where the reader points to on the small map. */
export function moveScroll(view: StageViewStore, box: ScrollBox, scroll: Scroll): void {
  const { layout } = view.getState();
  if (layout === null) return;
  view.setState({ scroll: clampScroll(layout, scroll) });
  applyScroll(view, box);
}
