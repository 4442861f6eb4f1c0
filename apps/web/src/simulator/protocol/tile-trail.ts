/**
 * The line that a robot leaves in its picture. A tile names cells, but its pose is exact: the corners
 * follow the poses, so that every leg is straight and the line ends at the robot. Pure.
 */
import { CELL } from "@corridor/maze";
import type { Tile } from "@corridor/protocol";
import { pathCells, type CellPoint } from "./tile-path.ts";

/** A robot this close to the line of a leg, in units, is on it. */
const NEAR = 10;
/** The newest corners of a line: as many as a path can have. */
const MAX_CORNERS = 200;

export interface Point {
  x: number;
  y: number;
}

/** The axis along which a leg runs. */
type Axis = keyof Point;

/** The corners of a line as far as a single tile shows them, without the robot. */
export function cornersOf(tile: Pick<Tile, "path" | "pose">): Point[] {
  const corners = pathCells(tile).map(centreOf);
  const own = corners.pop();
  const last = corners.at(-1);
  if (own === undefined) return [];
  if (last === undefined) return [own];
  const [x, y, heading] = tile.pose;
  const axis = axisOfHeading(heading);
  // The robot has turned in its cell, and left the leg on which it came.
  const hasTurned = axis !== axisOf(last, own) && Math.abs({ x, y }[axis] - own[axis]) > NEAR;
  return hasTurned ? [...corners, { ...own, [crossOf(axis)]: { x, y }[crossOf(axis)] }] : corners;
}

/** The whole line: its last leg moves sideways with the robot, so that it is straight. */
export function lineTo(corners: readonly Point[], { x, y }: Point): Point[] {
  const end = { x, y };
  const line = [...corners];
  const last = corners.at(-1);
  if (last === undefined) return [end];
  const cross = crossOf(axisOf(last, end));
  // A robot that drove back came on the same straight line.
  for (let at = line.length - 1; corners[at]?.[cross] === last[cross]; at--) {
    line[at] = { ...last, ...corners[at], [cross]: end[cross] };
  }
  return [...line, end];
}

/**
 * The corners around which a robot drove from one pose to the next.
 * @param start centre of the cell from which it came to the first of the cells
 * @param cells the corners as cells, from the old one to the new one
 */
export function turnsBetween(
  from: Point,
  to: Point & { heading: number },
  { start, cells }: { start: CellPoint; cells: readonly CellPoint[] },
): Point[] {
  if (cells.length === 0) {
    const isStraight = Math.min(Math.abs(to.x - from.x), Math.abs(to.y - from.y)) <= NEAR;
    if (isStraight) return [];
    return [axisOfHeading(to.heading) === "y" ? { x: to.x, y: from.y } : { x: from.x, y: to.y }];
  }
  const centres = cells.map(centreOf);
  const turns: Point[] = [];
  let [before, at] = [centreOf(start), from];
  for (const centre of centres) {
    const cross = crossOf(axisOf(before, centre));
    before = centre;
    at = { ...centre, [cross]: at[cross] };
    turns.push(at);
  }
  const cross = crossOf(axisOf(before, centreOf(cellOf(to))));
  turns.push({ ...at, ...turns.pop(), [cross]: to[cross] });
  return turns;
}

/**
 * The corners after a drive.
 * @param corners until `from`
 * @param turns see `turnsBetween`
 */
export function withTurns(
  corners: readonly Point[],
  from: Point,
  turns: readonly Point[],
  to: Point,
): Point[] {
  const line = lineTo(corners, from);
  const came = directionOf(corners.at(-1) ?? from, from);
  const goes = directionOf(from, turns[0] ?? to);
  const isOnWay = came === "" || goes === "" || came === goes;
  const before = isOnWay ? line.slice(0, -1) : line;
  return [...before, ...turns].slice(-MAX_CORNERS);
}

export function cellOf({ x, y }: Point): CellPoint {
  return { column: Math.floor(x / CELL), row: Math.floor(y / CELL) };
}

export function centreOf({ column, row }: CellPoint): Point {
  return { x: (column + 0.5) * CELL, y: (row + 0.5) * CELL };
}

function axisOf(from: Point, to: Point): Axis {
  return Math.abs(to.x - from.x) >= Math.abs(to.y - from.y) ? "x" : "y";
}

/** @param heading in degrees from north */
function axisOfHeading(heading: number): Axis {
  return (heading + 45) % 180 < 90 ? "y" : "x";
}

function crossOf(axis: Axis): Axis {
  return axis === "x" ? "y" : "x";
}

/** Such as "x1"; "" if the robot stands. */
function directionOf(from: Point, to: Point): string {
  const axis = axisOf(from, to);
  const sign = Math.sign(to[axis] - from[axis]);
  return sign === 0 ? "" : axis + sign;
}
