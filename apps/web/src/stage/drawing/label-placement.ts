/**
 * Placement of labels beside a beam: inside the view, never over the robot and never over each other.
 * A label stands in the quarter of the view around its own beam, so that it is not mistaken for the
 * label of another beam. Pure; pixels of the view.
 */
import type { Box } from "./viewport.ts";

interface Point {
  x: number;
  y: number;
}

/** A possible size of a label, with the centres for it. */
export interface TagSize {
  width: number;
  height: number;
  /** best first; within a group, positions that cover no avoided box come first */
  centres: readonly (readonly Point[])[];
}

/** A label to place. */
export interface LabelRequest<Name> {
  name: Name;
  /** best first; a smaller size is used if a larger one fits nowhere */
  sizes: readonly TagSize[];
}

export interface PlacedLabel<Name> extends Box {
  name: Name;
}

/** A beam from the robot's centre. */
export interface Beam {
  origin: Point;
  /** unit vector along it */
  dx: number;
  dy: number;
}

/** Pixels between a label and its subject. */
const GAP = 4;
/** Pixels between two candidate positions beside the robot. */
const STEP = 3;

/**
 * Places each label, in list order. A label that fits nowhere is omitted: covering the robot would be
 * worse, and the panel shows every number of the stage, too.
 * @param occupied boxes that no label may touch
 * @param bounds area for labels
 * @param avoided boxes that a label covers only if it has no other position
 */
export function placeLabels<Name>(
  requests: readonly LabelRequest<Name>[],
  occupied: readonly Box[],
  bounds: Box,
  avoided: readonly Box[] = [],
): PlacedLabel<Name>[] {
  const boxes = [...occupied];
  const placed: PlacedLabel<Name>[] = [];
  const isFree = (box: Box): boolean =>
    isWithin(box, bounds) && !boxes.some((other) => areTouching(box, other, GAP / 2));
  const isAvoiding = (box: Box): boolean => !avoided.some((other) => areTouching(box, other, 0));
  for (const { name, sizes } of requests) {
    const box = firstPlace(sizes, isFree, isAvoiding);
    if (box === null) continue;
    boxes.push(box);
    placed.push({ ...box, name });
  }
  return placed;
}

function firstPlace(
  sizes: readonly TagSize[],
  isFree: (box: Box) => boolean,
  isAvoiding: (box: Box) => boolean,
): Box | null {
  for (const { width, height, centres } of sizes) {
    for (const group of centres) {
      const free = group.map((centre) => boxAround(centre, width, height)).filter(isFree);
      const box = free.find(isAvoiding) ?? free[0];
      if (box !== undefined) return box;
    }
  }
  return null;
}

/**
 * Candidate positions of a reading: on the beam before its wall, beyond the wall, beside the beam,
 * or next to the robot. All of them are nearer to this beam than to its neighbours.
 * @param length pixels from the robot's centre to the wall
 * @param radius pixels around the robot's centre that labels may not cover
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
    // Small steps next to the robot: the label of the neighbouring beam shares the corner.
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
 * Candidate positions of a mark's label: beside the mark on either side, then farther out.
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

/**
 * Pixels from a beam's origin, which is inside the box, to the point where the beam leaves the box.
 */
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

/** The point at `along` pixels along a beam and `across` pixels to its right. */
function pointOn({ origin, dx, dy }: Beam, along: number, across: number): Point {
  return { x: origin.x + dx * along - dy * across, y: origin.y + dy * along + dx * across };
}

/** Half the size of an axis-parallel box, along and across a beam. */
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

/** Whether two boxes are less than `gap` pixels apart. */
function areTouching(a: Box, b: Box, gap: number): boolean {
  return (
    a.x < b.x + b.width + gap &&
    b.x < a.x + a.width + gap &&
    a.y < b.y + b.height + gap &&
    b.y < a.y + a.height + gap
  );
}
