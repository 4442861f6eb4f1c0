/** How much room the stage leaves around the maze, by its width and by what it shows. Pure. */
import {
  layOut,
  layOutFollowing,
  MIN_CELL_PX,
  MIN_CELL_PX_COMPACT,
  type Layout,
  type Padding,
} from "../../canvas/viewport.ts";

/** Below this width the stage is a phone's: the maze takes it whole, without rulers. */
const COMPACT_BELOW_PX = 600;

/** Side of a square while a camera goes with the robot: 0.6 px per unit. */
const FOLLOW_CELL_PX = 60;

const followed: Padding = { top: 16, right: 16, bottom: 16, left: 16 };
const compact: Padding = { top: 4, right: 8, bottom: 4, left: 8 };
const withRulers: Padding = { top: 36, right: 34, bottom: 20, left: 70 };
const withoutRulers: Padding = { top: 16, right: 34, bottom: 20, left: 34 };

/** Whether rulers are drawn: wished for, and there is room. */
export function hasRulers(width: number, showRulers: boolean): boolean {
  return showRulers && width >= COMPACT_BELOW_PX;
}

/** Divides the stage's drawing area (CSS pixels) for a maze. */
export function stageLayout(
  maze: { columns: number; rows: number },
  view: { width: number; height: number },
  showRulers: boolean,
): Layout {
  if (view.width < COMPACT_BELOW_PX) {
    const layout = layOut(maze, view, compact, MIN_CELL_PX_COMPACT);
    // Small squares leave no room for numbers beside the robot; the paper has no rulers on it here.
    return layout.overflows ? layout : { ...layout, paper: { x: 0, y: 0, ...view } };
  }
  return layOut(maze, view, showRulers ? withRulers : withoutRulers, MIN_CELL_PX);
}

/** Divides it for a camera that goes with the robot. */
export function followLayout(
  maze: { columns: number; rows: number },
  view: { width: number; height: number },
): Layout {
  return layOutFollowing(maze, view, followed, FOLLOW_CELL_PX);
}
