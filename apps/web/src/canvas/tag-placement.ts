/**
 * Where the readings stand: at the wall end of their beam, inside the maze that shows, never over the
 * robot and never over each other. Pure; pixels of the view.
 */
import type { Box } from "./viewport.ts";

/** A reading that wants a place. */
export interface TagRequest<Name> {
  name: Name;
  /** direction of its beam, a unit vector */
  dx: number;
  dy: number;
  /** pixels from the robot's centre to the wall */
  length: number;
  width: number;
  height: number;
}

export interface PlacedTag<Name> extends Box {
  name: Name;
}

/** Pixels between a tag and what it must not touch. */
const GAP = 4;

/**
 * Finds a place for each tag, the first in the list first. One that fits nowhere is left out: a
 * covered robot would be worse, and the reading stands in the panel too.
 * @param robot centre of the robot and half its side, in pixels
 * @param bounds where tags may stand
 */
export function placeTags<Name>(
  requests: readonly TagRequest<Name>[],
  robot: { x: number; y: number; radius: number },
  bounds: Box,
): PlacedTag<Name>[] {
  const taken: Box[] = [
    {
      x: robot.x - robot.radius,
      y: robot.y - robot.radius,
      width: 2 * robot.radius,
      height: 2 * robot.radius,
    },
  ];
  const placed: PlacedTag<Name>[] = [];
  for (const request of requests) {
    const box = candidates(request, robot).find(
      (each) => isWithin(each, bounds) && taken.every((other) => !areTouching(each, other)),
    );
    if (box === undefined) continue;
    taken.push(box);
    placed.push({ ...box, name: request.name });
  }
  return placed;
}

/** Places to try, best first: on the beam before the wall, beyond the wall, beside the beam. */
function* places<Name>(
  { dx, dy, length, width, height }: TagRequest<Name>,
  robot: { x: number; y: number; radius: number },
): Generator<{ x: number; y: number }> {
  const halfAlong = (Math.abs(dx) * width + Math.abs(dy) * height) / 2;
  const halfAcross = (Math.abs(dy) * width + Math.abs(dx) * height) / 2;
  const on = (along: number, across: number) => ({
    x: robot.x + dx * along - dy * across,
    y: robot.y + dy * along + dx * across,
  });
  yield on(length - halfAlong - GAP, 0);
  yield on(length + halfAlong + GAP + 2, 0);
  const beside = halfAcross + GAP + 4;
  yield on(Math.max(length - halfAlong, 0), beside);
  yield on(Math.max(length - halfAlong, 0), -beside);
  const clear = robot.radius + halfAcross + GAP + 2;
  for (const along of [length - halfAlong, 0, robot.radius + halfAlong]) {
    yield on(along, clear);
    yield on(along, -clear);
  }
  yield on(robot.radius + halfAlong + GAP, 0);
}

function candidates<Name>(
  request: TagRequest<Name>,
  robot: { x: number; y: number; radius: number },
): Box[] {
  const { width, height } = request;
  return [...places(request, robot)].map(({ x, y }) => ({
    x: Math.round(x - width / 2),
    y: Math.round(y - height / 2),
    width,
    height,
  }));
}

function isWithin(inner: Box, outer: Box): boolean {
  return (
    inner.x >= outer.x &&
    inner.y >= outer.y &&
    inner.x + inner.width <= outer.x + outer.width &&
    inner.y + inner.height <= outer.y + outer.height
  );
}

function areTouching(a: Box, b: Box): boolean {
  return (
    a.x < b.x + b.width + GAP / 2 &&
    b.x < a.x + a.width + GAP / 2 &&
    a.y < b.y + b.height + GAP / 2 &&
    b.y < a.y + a.height + GAP / 2
  );
}
