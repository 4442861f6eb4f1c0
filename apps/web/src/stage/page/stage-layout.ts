/** The padding around the maze, by the width of the stage and by what it displays. Pure. */
import {
  layOut,
  layOutFollowing,
  MIN_CELL_PX,
  MIN_CELL_PX_COMPACT,
  MIN_WHOLE_CELL_PX,
  type Layout,
  type Padding,
} from "../drawing/viewport.ts";

/** Below this width the layout is that of a phone: the maze fills the stage, without rulers. */
const COMPACT_BELOW_PX = 600;

/** Side of a square while a camera follows the robot: 0.6 px per unit. */
const FOLLOW_CELL_PX = 60;

/** Room for the small label of a reading beside a robot that touches the maze's frame. */
const tagRoom: Padding = { top: 19, right: 26, bottom: 19, left: 26 };
/**
 * Also leaves room for the button over the stage, which would cover the label of a robot at the upper
 * end of the maze.
 */
const belowButton: Padding = { ...tagRoom, top: 78 };
/** Below this height the maze fills the stage, and readings outside of it are omitted. */
const TAG_ROOM_FROM_PX = 120;
const compact: Padding = { top: 4, right: 8, bottom: 4, left: 8 };
const withRulers: Padding = { top: 36, right: 34, bottom: 20, left: 70 };
const withoutRulers: Padding = { top: 19, right: 34, bottom: 20, left: 34 };

/** Whether to draw rulers: they are enabled, and there is room for them. */
export function hasRulers(width: number, showRulers: boolean): boolean {
  return showRulers && width >= COMPACT_BELOW_PX;
}

/**
 * The zoom that the user has chosen: side of a square in CSS pixels, or the whole maze at any size;
 * null for the initial size of a maze.
 */
export type Zoom = number | "fit" | null;

/** Computes the layout of a maze in the stage's drawing area (CSS pixels). */
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
 * @param minWholePx minimum side of a square at which the whole maze is displayed initially
 * @param cutPx side of a square if the maze does not fit
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

/** What the layout depends on. */
export interface StageRoom {
  maze: Size;
  view: { width: number; height: number };
  showRulers: boolean;
  /** whether a camera follows the robot */
  follows: boolean;
  zoom: Zoom;
}

/** Computes the layout for a camera or for the whole maze. */
export function divideStage({ maze, view, showRulers, follows, zoom }: StageRoom): Layout {
  if (!follows) return stageLayout(maze, view, showRulers, zoom);
  const cellPx = typeof zoom === "number" ? Math.round(zoom) : FOLLOW_CELL_PX;
  const layout = layOutFollowing(maze, view, tagRoom, cellPx);
  return layout.follows ? layOutFollowing(maze, view, belowButton, cellPx) : layout;
}
