/**
 * The robot of a student between two tiles. Tiles arrive about twice a second; the displayed robot
 * follows them about one tile later, along the cells that its newest path names. It never moves
 * beyond its newest tile. A robot that did not drive from one tile to the next (a reset, another
 * maze) jumps. Pure; the time is given.
 */
import { TILE_INTERVAL_MS, type Pose, type Tile } from "@corridor/protocol";
import { blendHeading } from "../protocol/blend-heading.ts";
import { pathCells, type CellPoint } from "../protocol/tile-path.ts";
import {
  cellOf,
  centreOf,
  cornersOf,
  lineTo,
  turnsBetween,
  withTurns,
  type Point,
} from "../protocol/tile-trail.ts";

/** Bounds of the interval between two tiles, in ms. */
const LEAST_GAP_MS = 100;
const MOST_GAP_MS = 700;
/** A tile may be this late without a stop of the robot, in ms. */
const LATE_MS = 80;
/** Largest number of queued tiles; older ones are skipped, for example in a hidden tab. */
const MOST_WAITING = 6;
/** A robot this close to the centre of a cell, in units, is at it. */
const NEAR = 10;

/** What the picture of a student shows. */
export interface ShownTile {
  tile: Tile;
  /** the path, in units; every leg is straight, and the last one ends at the robot */
  trail: readonly Point[];
  pose: Pose;
}

interface Step {
  tile: Tile;
  pose: Pose;
  /** ms */
  at: number;
  /** of the path, without the robot */
  corners: readonly Point[];
  /** the newest corners: those since the previous tile; null: the robot did not drive here */
  turns: readonly Point[] | null;
  trail: readonly Point[];
}

export class TileMotion {
  /** the displayed tile, then its successors */
  #steps: Step[] = [];
  #gapMs = TILE_INTERVAL_MS;
  #shownAt = Number.NEGATIVE_INFINITY;

  /** @param at monotonic ms */
  add(tile: Tile, at: number): void {
    const newest = this.#steps.at(-1);
    if (newest?.tile === tile) return;
    const pose = poseOf(tile);
    const way = newest === undefined ? null : wayBetween(newest, tile);
    const turns = newest && way && turnsBetween(newest.pose, pose, way);
    const corners =
      newest && turns ? withTurns(newest.corners, newest.pose, turns, pose) : cornersOf(tile);
    const step = { tile, pose, at, corners, turns: turns ?? null, trail: lineTo(corners, pose) };
    const isAlone = this.#steps.length === 1;
    // A robot that stands needs no delay.
    if (
      newest === undefined ||
      (isAlone && (step.turns === null || isSamePose(newest.pose, pose)))
    ) {
      this.#steps = [step];
      return;
    }
    const gap = at - newest.at;
    // Tiles are sent on change: a long gap says nothing about regularity.
    if (gap <= MOST_GAP_MS) this.#gapMs += (Math.max(LEAST_GAP_MS, gap) - this.#gapMs) / 4;
    // The robot stood until now, and leaves now.
    if (isAlone) newest.at = Math.max(newest.at, at - this.#gapMs);
    this.#steps.push(step);
    if (this.#steps.length > MOST_WAITING) this.#steps.shift();
  }

  /** Whether the robot has not reached its newest tile. */
  get isMoving(): boolean {
    return this.#steps.length > 1;
  }

  /** The robot at a time, which does not decrease; null: there is no tile. */
  shown(now: number): ShownTile | null {
    const at = (this.#shownAt = Math.max(this.#shownAt, now - this.#gapMs - LATE_MS));
    while ((this.#steps[1]?.at ?? Number.POSITIVE_INFINITY) <= at) this.#steps.shift();
    const [from, to] = this.#steps;
    if (from === undefined) return null;
    const share = to === undefined ? 0 : (at - from.at) / (to.at - from.at);
    if (to === undefined || to.turns === null || share <= 0) return from;
    return between(from, to, to.turns, share);
  }

  /** The newest tile at once, without motion. */
  newest(): ShownTile | null {
    this.#steps = this.#steps.slice(-1);
    return this.#steps[0] ?? null;
  }
}

/** @param share of the way, in (0, 1) */
function between(from: Step, to: Step, turns: readonly Point[], share: number): ShownTile {
  const way = [from.pose, ...turns, to.pose];
  const lengths = way.slice(1).map((point, at) => distance(way[at] ?? point, point));
  let left = share * lengths.reduce((sum, length) => sum + length, 0);
  let passed = 0;
  while (passed < turns.length && left > (lengths[passed] ?? 0)) left -= lengths[passed++] ?? 0;
  const [start, end] = [way[passed] ?? from.pose, way[passed + 1] ?? to.pose];
  const part = Math.min(1, left / Math.max(lengths[passed] ?? 0, Number.MIN_VALUE));
  const pose = {
    x: start.x + (end.x - start.x) * part,
    y: start.y + (end.y - start.y) * part,
    heading: blendHeading(from.pose.heading, to.pose.heading, share),
  };
  const corners = to.corners.slice(0, to.corners.length - turns.length + passed);
  return { tile: from.tile, trail: lineTo(corners, pose), pose };
}

/** The corners that a robot drove around; null: it did not drive from the one tile to the other. */
function wayBetween(
  { tile: before, pose }: Step,
  tile: Tile,
): { start: CellPoint; cells: CellPoint[] } | null {
  const isOther = before.task !== tile.task || before.maze !== tile.maze || tile.tick < before.tick;
  if (isOther) return null;
  const path = pathCells(tile);
  const cell = cellOf(pose);
  for (let at = path.length - 1; at >= 0; at--) {
    const end = path[at];
    const start = path[Math.max(0, at - 1)];
    if (start === undefined || end === undefined || !isOnWay(cell, start, end)) continue;
    // The last cell is the robot's own. Its position is known better than the centre of its cell.
    const cells = path.slice(at, -1);
    const [first] = cells;
    // In the cell of the corner, the robot may have turned already.
    const isPassed = first !== undefined && isSameCell(cell, end) && !isAhead(end, pose, start);
    return isPassed ? { start: end, cells: cells.slice(1) } : { start, cells };
  }
  return null;
}

/** Whether a corner is still ahead of a robot that came from a cell. */
function isAhead(cell: CellPoint, pose: Point, from: CellPoint): boolean {
  const [corner, start] = [centreOf(cell), centreOf(from)];
  const length = distance(start, corner);
  if (length === 0) return false;
  const along =
    ((corner.x - pose.x) * (corner.x - start.x) + (corner.y - pose.y) * (corner.y - start.y)) /
    length;
  return along > NEAR;
}

/** Whether a cell is on the straight way from a cell to another one. */
function isOnWay({ column, row }: CellPoint, a: CellPoint, b: CellPoint): boolean {
  return (
    column >= Math.min(a.column, b.column) &&
    column <= Math.max(a.column, b.column) &&
    row >= Math.min(a.row, b.row) &&
    row <= Math.max(a.row, b.row)
  );
}

function poseOf({ pose: [x, y, heading] }: Tile): Pose {
  return { x, y, heading };
}

function isSamePose(a: Pose, b: Pose): boolean {
  return a.x === b.x && a.y === b.y && a.heading === b.heading;
}

function isSameCell(a: CellPoint, b: CellPoint): boolean {
  return a.column === b.column && a.row === b.row;
}

function distance(a: Point, b: Point): number {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  return Math.sqrt(dx * dx + dy * dy);
}
