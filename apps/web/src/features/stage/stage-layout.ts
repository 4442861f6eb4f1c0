/** How much room the stage leaves around the maze, by its width and by what it shows. Pure. */
import {
  layOut,
  layOutFollowing,
  MIN_CELL_PX,
  MIN_CELL_PX_COMPACT,
  MIN_WHOLE_CELL_PX,
  type Layout,
  type Padding,
} from "../../canvas/viewport.ts";

/** Below this width the stage is a phone's: the maze takes it whole, without rulers. */
const COMPACT_BELOW_PX = 600;

/** Side of a square while a camera goes with the robot: 0.6 px per unit. */
const FOLLOW_CELL_PX = 60;

/** Room for the small tag of a reading beside a robot that touches the maze's frame. */
const tagRoom: Padding = { top: 19, right: 26, bottom: 19, left: 26 };
/** Besides, room for the button over the stage: the tag above a robot at the upper end of the maze stands below it. */
const belowButton: Padding = { ...tagRoom, top: 78 };
/** Below this height the maze takes the stage whole, and readings outside of it are left out. */
const TAG_ROOM_FROM_PX = 120;
const compact: Padding = { top: 4, right: 8, bottom: 4, left: 8 };
const withRulers: Padding = { top: 36, right: 34, bottom: 20, left: 70 };
const withoutRulers: Padding = { top: 19, right: 34, bottom: 20, left: 34 };

/** Whether rulers are drawn: wished for, and there is room. */
export function hasRulers(width: number, showRulers: boolean): boolean {
  return showRulers && width >= COMPACT_BELOW_PX;
}

/**
 * The zoom that the reader chose: side of a square in CSS pixels, or the whole maze however small; null for the
 * size at which a maze opens.
 */
export type Zoom = number | "fit" | null;

/** Divides the stage's drawing area (CSS pixels) for a maze. */
export function stageLayout(
  maze: Size,
  view: { width: number; height: number },
  showRulers: boolean,
  zoom: Zoom = null,
): Layout {
  if (view.width < COMPACT_BELOW_PX) {
    const padding = view.height < TAG_ROOM_FROM_PX ? compact : tagRoom;
    return zoomed(maze, view, padding, zoom, MIN_CELL_PX_COMPACT, MIN_CELL_PX_COMPACT);
  }
  const padding = showRulers ? withRulers : withoutRulers;
  return zoomed(maze, view, padding, zoom, MIN_WHOLE_CELL_PX, MIN_CELL_PX);
}

/**
 * @param minWholePx the smallest squares at which the maze opens whole
 * @param cutPx the squares of a maze that does not
 */
function zoomed(
  maze: Size,
  view: { width: number; height: number },
  padding: Padding,
  zoom: Zoom,
  minWholePx: number,
  cutPx: number,
): Layout {
  if (typeof zoom === "number") {
    const cellPx = Math.max(1, Math.round(zoom));
    return layOut(maze, view, padding, cellPx, cellPx);
  }
  const layout = layOut(maze, view, padding, zoom === "fit" ? 1 : minWholePx);
  const isCut = layout.overflows && zoom === null && cutPx > minWholePx;
  return isCut ? layOut(maze, view, padding, cutPx) : layout;
}

interface Size {
  columns: number;
  rows: number;
}

/** What the stage's division depends on. */
export interface StageRoom {
  maze: Size;
  view: { width: number; height: number };
  showRulers: boolean;
  /** whether a camera goes with the robot */
  follows: boolean;
  zoom: Zoom;
}

/** Divides the stage's drawing area, for a camera or for the whole maze. */
export function divideStage({ maze, view, showRulers, follows, zoom }: StageRoom): Layout {
  if (!follows) return stageLayout(maze, view, showRulers, zoom);
  const cellPx = typeof zoom === "number" ? Math.round(zoom) : FOLLOW_CELL_PX;
  const layout = layOutFollowing(maze, view, tagRoom, cellPx);
  return layout.follows ? layOutFollowing(maze, view, belowButton, cellPx) : layout;
}
