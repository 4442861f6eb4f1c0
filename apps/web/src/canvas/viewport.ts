/**
 * Where the maze stands in the stage: centimetres to pixels and back.
 *
 * Pure. "View" is the visible drawing area in CSS pixels; "content" is what can be scrolled through,
 * which is the view itself as long as the whole maze fits. Squares are whole pixels wide, so that
 * hairlines stay sharp.
 */

/** Units along one side of a cell. */
export const CELL = 100;
/** Squares of a maze that is too large for the stage: 0.3 px per unit. */
export const MIN_CELL_PX = 30;
/** A maze opens whole down to this size: one of 21 by 21 squares fits a screen of 1440 by 900. */
export const MIN_WHOLE_CELL_PX = 24;
/** On short phones the whole of a maze, its goal included, is worth more than large squares. */
export const MIN_CELL_PX_COMPACT = 10;
/** A tiny maze does not blow the robot up to the size of the screen: 2 px per unit. */
export const MAX_CELL_PX = 200;

/** Free pixels around the maze: for rulers, and for the reader's eye. */
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

/** How the stage is divided, for one size of maze and screen. */
export interface Layout {
  columns: number;
  rows: number;
  /** side of a cell in whole CSS pixels */
  cellPx: number;
  view: { width: number; height: number };
  /** size of what can be scrolled through, at least the view */
  content: { width: number; height: number };
  /** top-left corner of the maze in the content */
  origin: { x: number; y: number };
  /** the part of the view in which the maze may show */
  port: Box;
  /** whether only a part of the maze shows at a time, and the stage is scrolled */
  overflows: boolean;
  /** whether only a part of the maze shows at a time, and a camera goes with the robot */
  follows: boolean;
}

/** The transformation for drawing: view pixel = origin + units * scale. */
export interface Viewport {
  /** CSS pixels per unit */
  scale: number;
  originX: number;
  originY: number;
  port: Box;
  /** all of the drawing area: numbers of the maze may stand around it, too */
  view: Box;
  columns: number;
  rows: number;
}

/** Scroll position of the content in CSS pixels. */
export interface Scroll {
  x: number;
  y: number;
}

/** Divides a view for a maze: the largest whole squares that fit, else the smallest that can be read. */
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
  // A maze that is cut begins at its padding, so the port does too, wherever it is scrolled.
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
 * Divides a view for a camera that goes with the robot: squares of a fixed size, and the maze reaches the
 * view's edges. A maze that fits as a whole needs no camera and is shown as large as it fits.
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

/** Where the robot's run is drawn: a maze that is cut ends at the port, and so does its run. */
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

/** Cells that show, as half-open ranges; drawing anything else would be wasted. */
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

/** Share of the port at each side in which the robot makes the stage move on. */
const FOLLOW_MARGIN = 0.2;

/**
 * Where to scroll so that a point stays in sight: nowhere while it is well inside, else so that it
 * stands in the middle. Jumps instead of creeping, so that walls are not drawn anew on every frame.
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

/** The nearest scroll position at which the layout shows no more than its content. */
export function clampScroll({ content, view }: Layout, scroll: Scroll): Scroll {
  const within = (at: number, most: number): number => Math.min(Math.max(0, most), Math.max(0, at));
  return {
    x: within(scroll.x, content.width - view.width),
    y: within(scroll.y, content.height - view.height),
  };
}

/**
 * Where a camera stands that has a point in its middle, but never shows more than the padding beyond the
 * maze: near the maze's edges the point leaves the middle and the camera stands still.
 * @param x position in units
 * @param y position in units
 */
export function centredScroll(layout: Layout, x: number, y: number): Scroll {
  return clampScroll(layout, unboundedCentre(layout, x, y));
}

/** Share of the view between two places of a camera that cuts instead of moving. */
const CUT_SHARE = 0.6;

/**
 * Where a camera stands that cuts: the nearest of fixed places to the one that has the point in its
 * middle. The point is never nearer to an edge of the view than a fifth of it, but at the maze's edges.
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
