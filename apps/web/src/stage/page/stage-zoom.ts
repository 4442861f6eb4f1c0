/** Zooms the stage. Pure except for the view store; loads when the user first zooms. */
import { CELL } from "@corridor/maze";
import { clampScroll, MAX_CELL_PX, type Layout, type Scroll } from "../drawing/viewport.ts";
import { isInPort } from "./grid-place.ts";
import { divideStage, type StageRoom } from "./stage-layout.ts";
import type { StageViewStore } from "./stage-view.ts";

/** A step of the buttons and keys, the whole maze, or a factor from a wheel or two fingers. */
export type ZoomBy = "in" | "out" | "fit" | { factor: number };

/** A point in pixels of the view, or in units of the maze. */
export interface Point {
  x: number;
  y: number;
}

const STEP = 1.25;

/**
 * @param at pixel of the view that stays in place; null: the robot stays, or moves to the middle
 * @param robot position in units
 */
export function zoomStage(
  view: StageViewStore,
  room: StageRoom,
  by: ZoomBy,
  at: Point | null,
  robot: Point | null,
): void {
  const { layout: before, scroll, zoom } = view.getState();
  if (before === null) return;
  const least = divideStage({ ...room, follows: false, zoom: "fit" }).cellPx;
  const now = typeof zoom === "number" && Math.round(zoom) === before.cellPx ? zoom : before.cellPx;
  const target = targetOf(now, by, least);
  const next = target <= least ? "fit" : Math.min(target, MAX_CELL_PX);
  const layout = divideStage({ ...room, zoom: next });
  const anchor = at === null ? robotAnchor(before, scroll, robot) : anchorAt(before, scroll, at);
  const scale = layout.cellPx / CELL;
  view.setState({
    zoom: next,
    layout,
    scroll: clampScroll(layout, {
      x: layout.origin.x + anchor.units.x * scale - anchor.pixel.x,
      y: layout.origin.y + anchor.units.y * scale - anchor.pixel.y,
    }),
  });
}

function targetOf(now: number, by: ZoomBy, least: number): number {
  if (by === "fit") return least;
  if (by === "in") return Math.max(Math.floor(now) + 1, now * STEP);
  if (by === "out") return Math.min(Math.ceil(now) - 1, now / STEP);
  return now * by.factor;
}

/** A point of the maze and its pixel in the view after zooming. */
interface Anchor {
  units: Point;
  pixel: Point;
}

function anchorAt({ origin, cellPx }: Layout, scroll: Scroll, pixel: Point): Anchor {
  const unitsPerPixel = CELL / cellPx;
  const x = (pixel.x - origin.x + scroll.x) * unitsPerPixel;
  const y = (pixel.y - origin.y + scroll.y) * unitsPerPixel;
  return { units: { x, y }, pixel };
}

function robotAnchor(layout: Layout, scroll: Scroll, robot: Point | null): Anchor {
  const { port, origin, cellPx } = layout;
  const middle = { x: port.x + port.width / 2, y: port.y + port.height / 2 };
  if (robot === null) return anchorAt(layout, scroll, middle);
  const pixel = {
    x: origin.x - scroll.x + (robot.x * cellPx) / CELL,
    y: origin.y - scroll.y + (robot.y * cellPx) / CELL,
  };
  return { units: robot, pixel: isInPort(layout, pixel.x, pixel.y) ? pixel : middle };
}
