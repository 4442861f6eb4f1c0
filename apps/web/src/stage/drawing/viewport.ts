/**
 * Position of the maze in the stage: converts units to pixels and back.
 *
 * Pure. "View" is the visible drawing area in CSS pixels. "Content" is the scrollable area, which
 * equals the view while the whole maze fits. Cells are whole pixels wide, so that hairlines stay
 * sharp.
 */
import { CELL } from "@corridor/maze";

/** Cell size of a maze that is too large for the stage: 0.3 px per unit. */
export const MIN_CELL_PX = 30;
/**
 * Smallest cell size at which a maze opens as a whole: 21 by 21 cells fit a screen of 1440 by 900.
 */
export const MIN_WHOLE_CELL_PX = 24;
/** The same on short phones, where seeing the goal matters more than large cells. */
export const MIN_CELL_PX_COMPACT = 10;
/**
 * Largest cell size, so that a tiny maze does not fill the screen with the robot: 2 px per unit.
 */
export const MAX_CELL_PX = 200;

/** Pixels around the maze, for rulers and white space. */
export interface Padding {
  top: number;
  right: number;
  bottom: number;
  left: number;
}

/** A rectangle in CSS pixels. */
export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** Division of the stage for one maze size and one screen size. */
export interface Layout {
  columns: number;
  rows: number;
  /** side of a cell in whole CSS pixels */
  cellPx: number;
  view: { width: number; height: number };
  /** size of the scrollable area, at least the view */
  content: { width: number; height: number };
  /** top-left corner of the maze in the content */
  origin: { x: number; y: number };
  /** the part of the view that shows the maze */
  port: Box;
  /** whether the maze is larger than the port, and the stage scrolls */
  overflows: boolean;
  /** whether the maze is larger than the port, and a camera follows the robot */
  follows: boolean;
}

/** Transformation for drawing: view pixel = origin + units * scale. */
export interface Viewport {
  /** CSS pixels per unit */
  scale: number;
  originX: number;
  originY: number;
  port: Box;
  /** the whole drawing area; numbers may stand around the maze, too */
  view: Box;
  columns: number;
  rows: number;
}

/** Scroll position of the content in CSS pixels. */
export interface Scroll {
  x: number;
  y: number;
}

/**
 * Lays out a maze in a view: the largest cells in whole pixels that fit, but at least the smallest
 * readable ones.
 */
export function layOut(
  maze: { columns: number; rows: number },
  view: { width: number; height: number },
  padding: Padding,
  minCellPx: number,
  maxCellPx = MAX_CELL_PX,
): Layout {
  const { columns, rows } = maze;
  const roomX = Math.max(1, view.width - padding.left - padding.right);
  const roomY = Math.max(1, view.height - padding.top - padding.bottom);
  const fitting = Math.floor(Math.min(roomX / columns, roomY / rows));
  const cellPx = Math.min(maxCellPx, Math.max(minCellPx, fitting));
  const width = columns * cellPx;
  const height = rows * cellPx;
  const isWide = width > roomX;
  const isTall = height > roomY;
  const origin = {
    x: padding.left + (isWide ? 0 : Math.floor((roomX - width) / 2)),
    y: padding.top + (isTall ? 0 : Math.floor((roomY - height) / 2)),
  };
  // A clipped maze starts at its padding, so the port does too, at every scroll position.
  const port = { ...origin, width: Math.min(width, roomX), height: Math.min(height, roomY) };
  return {
    columns,
    rows,
    cellPx,
    view,
    content: {
      width: isWide ? width + padding.left + padding.right : view.width,
      height: isTall ? height + padding.top + padding.bottom : view.height,
    },
    origin,
    port,
    overflows: isWide || isTall,
    follows: false,
  };
}

/**
 * Lays out a maze for a camera that follows the robot: cells of a fixed size, and the maze reaches
 * the view's edges. A maze that fits as a whole needs no camera and is as large as possible.
 */
export function layOutFollowing(
  maze: { columns: number; rows: number },
  view: { width: number; height: number },
  padding: Padding,
  cellPx: number,
): Layout {
  const layout = layOut(maze, view, padding, cellPx);
  if (!layout.overflows) return layout;
  const port = { x: 0, y: 0, ...view };
  return { ...layout, port, overflows: false, follows: true };
}

/** The transformation at a scroll position. */
export function viewportAt(layout: Layout, scroll: Scroll): Viewport {
  return {
    scale: layout.cellPx / CELL,
    originX: layout.origin.x - scroll.x,
    originY: layout.origin.y - scroll.y,
    port: layout.port,
    view: { x: 0, y: 0, ...layout.view },
    columns: layout.columns,
    rows: layout.rows,
  };
}

/** The box for drawing the run: the port if the maze is clipped, otherwise the view. */
export function runBox({ port, view, columns, rows, scale }: Viewport): Box {
  const isCut = columns * CELL * scale > port.width || rows * CELL * scale > port.height;
  return isCut ? port : view;
}

/** View pixel of a horizontal position in units. */
export function viewX(viewport: Viewport, x: number): number {
  return viewport.originX + x * viewport.scale;
}

/** View pixel of a vertical position in units. */
export function viewY(viewport: Viewport, y: number): number {
  return viewport.originY + y * viewport.scale;
}

/**
 * The cell under a point.
 * @param x pixels from the maze's left edge
 * @param y pixels from the maze's top edge
 * @returns null outside of the maze
 */
export function cellAt(
  layout: Layout,
  x: number,
  y: number,
): { column: number; row: number } | null {
  const column = Math.floor(x / layout.cellPx);
  const row = Math.floor(y / layout.cellPx);
  const isInside = column >= 0 && row >= 0 && column < layout.columns && row < layout.rows;
  return isInside ? { column, row } : null;
}

/** Visible cells, as half-open ranges. */
export interface CellRange {
  fromColumn: number;
  toColumn: number;
  fromRow: number;
  toRow: number;
}

/** The cells that touch the port. */
export function visibleCells(viewport: Viewport): CellRange {
  const { port, originX, originY, columns, rows } = viewport;
  const cellPx = viewport.scale * CELL;
  const clamp = (value: number, most: number) => Math.min(most, Math.max(0, value));
  return {
    fromColumn: clamp(Math.floor((port.x - originX) / cellPx), columns),
    toColumn: clamp(Math.ceil((port.x + port.width - originX) / cellPx), columns),
    fromRow: clamp(Math.floor((port.y - originY) / cellPx), rows),
    toRow: clamp(Math.ceil((port.y + port.height - originY) / cellPx), rows),
  };
}

/**
 * Margin at each side of the port in which the robot makes the stage scroll, as a share of the
 * port.
 */
const FOLLOW_MARGIN = 0.2;

/**
 * Scroll position that shows a point: unchanged while the point is well inside the port, otherwise
 * centred on it. It jumps instead of moving gradually, so that the walls are not redrawn on every
 * frame.
 * @param x position in units
 * @param y position in units
 */
export function followScroll(layout: Layout, scroll: Scroll, x: number, y: number): Scroll {
  const scale = layout.cellPx / CELL;
  const along = (at: number, now: number, from: number, length: number, most: number): number => {
    const inPort = at - now - from;
    const margin = Math.min(length * FOLLOW_MARGIN, length / 2);
    if (inPort >= margin && inPort <= length - margin) return now;
    return Math.min(most, Math.max(0, Math.round(at - from - length / 2)));
  };
  const { port, origin, content, view } = layout;
  return {
    x: along(origin.x + x * scale, scroll.x, port.x, port.width, content.width - view.width),
    y: along(origin.y + y * scale, scroll.y, port.y, port.height, content.height - view.height),
  };
}

/** The nearest scroll position that shows nothing beyond the content. */
export function clampScroll({ content, view }: Layout, scroll: Scroll): Scroll {
  const within = (at: number, most: number): number => Math.min(Math.max(0, most), Math.max(0, at));
  return {
    x: within(scroll.x, content.width - view.width),
    y: within(scroll.y, content.height - view.height),
  };
}

/**
 * Scroll position that centres a point, without showing more than the padding beyond the maze. Near
 * the maze's edges the point leaves the centre and the position stands still.
 * @param x position in units
 * @param y position in units
 */
export function centredScroll(layout: Layout, x: number, y: number): Scroll {
  return clampScroll(layout, unboundedCentre(layout, x, y));
}

/** Distance between two positions of a jumping camera, as a share of the view. */
const CUT_SHARE = 0.6;

/**
 * Scroll position of a jumping camera: the nearest fixed position to the one that centres the
 * point. The point is at least a fifth of the view away from its edges, except at the maze's edges.
 */
export function steppedScroll(layout: Layout, x: number, y: number): Scroll {
  const middle = unboundedCentre(layout, x, y);
  const nearest = (at: number, step: number): number => Math.round(at / step) * step;
  const { view } = layout;
  return clampScroll(layout, {
    x: nearest(middle.x, view.width * CUT_SHARE),
    y: nearest(middle.y, view.height * CUT_SHARE),
  });
}

function unboundedCentre({ cellPx, origin, view }: Layout, x: number, y: number): Scroll {
  const scale = cellPx / CELL;
  return { x: origin.x + x * scale - view.width / 2, y: origin.y + y * scale - view.height / 2 };
}
