/**
 * Where little tags stand beside a beam: inside the view, never over the robot and never over each
 * other. The tag of a beam stands in the quarter of the view that its beam halves, so that nobody
 * reads it as the tag of another beam. Pure; pixels of the view.
 */
import type { Box } from "./viewport.ts";

interface Point {
  x: number;
  y: number;
}

/** A size that a tag may have, and the centres that suit it. */
export interface TagSize {
  width: number;
  height: number;
  /** best first; within a group, one that spares what should stay in sight comes before the others */
  centres: readonly (readonly Point[])[];
}

/** A tag that wants a place. */
export interface TagRequest<Name> {
  name: Name;
  /** best first: a smaller one is taken where a larger one has no place */
  sizes: readonly TagSize[];
}

export interface PlacedTag<Name> extends Box {
  name: Name;
}

/** A beam from the robot's centre. */
export interface Beam {
  origin: Point;
  /** unit vector along it */
  dx: number;
  dy: number;
}

/** Pixels between a tag and what it belongs to. */
const GAP = 4;
/** Pixels between two places beside the robot. */
const STEP = 3;

/**
 * Finds a place for each tag, the first in the list first. One that fits nowhere is left out: a
 * covered robot would be worse, and every number of the stage stands in the panel too.
 * @param taken what no tag may touch
 * @param bounds where tags may stand
 * @param spared what a tag covers only where it has no other place
 */
export function placeTags<Name>(
  requests: readonly TagRequest<Name>[],
  taken: readonly Box[],
  bounds: Box,
  spared: readonly Box[] = [],
): PlacedTag<Name>[] {
  const occupied = [...taken];
  const placed: PlacedTag<Name>[] = [];
  const isFree = (box: Box): boolean =>
    isWithin(box, bounds) && !occupied.some((other) => areTouching(box, other, GAP / 2));
  const isSparing = (box: Box): boolean => !spared.some((other) => areTouching(box, other, 0));
  for (const { name, sizes } of requests) {
    const box = firstPlace(sizes, isFree, isSparing);
    if (box === null) continue;
    occupied.push(box);
    placed.push({ ...box, name });
  }
  return placed;
}

function firstPlace(
  sizes: readonly TagSize[],
  isFree: (box: Box) => boolean,
  isSparing: (box: Box) => boolean,
): Box | null {
  for (const { width, height, centres } of sizes) {
    for (const group of centres) {
      const free = group.map((centre) => boxAround(centre, width, height)).filter(isFree);
      const box = free.find(isSparing) ?? free[0];
      if (box !== undefined) return box;
    }
  }
  return null;
}

/**
 * Places for a reading: on the beam before its wall, beyond the wall, beside the beam; else next to the
 * robot. All of them are nearer to this beam than to the ones beside it.
 * @param length pixels from the robot's centre to the wall
 * @param radius pixels around the robot's centre that it needs
 */
export function readingCentres(
  beam: Beam,
  length: number,
  radius: number,
  width: number,
  height: number,
): Point[][] {
  const { along: halfAlong, across: halfAcross } = halfExtents(beam, width, height);
  const beside = halfAcross + GAP + 4;
  const atWall = length - halfAlong;
  const atRobot = radius + halfAlong + GAP / 2 + 1;
  const groups = [
    [
      { along: atWall - GAP, across: 0 },
      { along: length + halfAlong + GAP + 2, across: 0 },
      { along: atWall, across: beside },
      { along: atWall, across: -beside },
    ],
    // Next to the robot in small steps: a corner is shared with the tag of the beam beside it.
    [0, 1, 2, 3].flatMap((out) =>
      [0, 1, -1, 2, -2, 3, -3].map((side) => ({
        along: atRobot + out * STEP,
        across: side * STEP,
      })),
    ),
  ];
  return groups.map((places) =>
    places
      .filter(({ along, across }) => Math.abs(across) <= along)
      .map(({ along, across }) => pointOn(beam, along, across)),
  );
}

/**
 * Places for the tag of a mark on a beam: beside it on either side, then farther out.
 * @param distance pixels from the robot's centre to the mark
 * @param reach half the length of the mark's bar in pixels
 */
export function markCentres(
  beam: Beam,
  distance: number,
  reach: number,
  width: number,
  height: number,
): Point[][] {
  const { along: halfAlong, across: halfAcross } = halfExtents(beam, width, height);
  const across = reach + halfAcross;
  const places = [0, halfAlong - GAP, GAP - halfAlong].flatMap((shift) => [
    pointOn(beam, distance + shift, across),
    pointOn(beam, distance + shift, -across),
  ]);
  return [places];
}

/** Pixels from a beam's origin, which lies inside a box, to where the beam leaves it. */
export function lengthInside({ origin, dx, dy }: Beam, box: Box): number {
  const along = (at: number, step: number, from: number, to: number): number => {
    if (step === 0) return Number.POSITIVE_INFINITY;
    return Math.max(0, ((step > 0 ? to : from) - at) / step);
  };
  return Math.min(
    along(origin.x, dx, box.x, box.x + box.width),
    along(origin.y, dy, box.y, box.y + box.height),
  );
}

/** A point so many pixels along a beam and to its right. */
function pointOn({ origin, dx, dy }: Beam, along: number, across: number): Point {
  return { x: origin.x + dx * along - dy * across, y: origin.y + dy * along + dx * across };
}

/** Half the size of an upright box as a beam sees it. */
function halfExtents(
  { dx, dy }: Beam,
  width: number,
  height: number,
): { along: number; across: number } {
  return {
    along: (Math.abs(dx) * width + Math.abs(dy) * height) / 2,
    across: (Math.abs(dy) * width + Math.abs(dx) * height) / 2,
  };
}

/** On whole pixels, so that its edges are sharp. */
function boxAround({ x, y }: Point, width: number, height: number): Box {
  return { x: Math.round(x - width / 2), y: Math.round(y - height / 2), width, height };
}

function isWithin(inner: Box, outer: Box): boolean {
  return (
    inner.x >= outer.x &&
    inner.y >= outer.y &&
    inner.x + inner.width <= outer.x + outer.width &&
    inner.y + inner.height <= outer.y + outer.height
  );
}

/** Whether fewer pixels than `air` are between them. */
function areTouching(a: Box, b: Box, air: number): boolean {
  return (
    a.x < b.x + b.width + air &&
    b.x < a.x + a.width + air &&
    a.y < b.y + b.height + air &&
    b.y < a.y + a.height + air
  );
}
