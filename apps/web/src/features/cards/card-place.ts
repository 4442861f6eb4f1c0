/**
 * Where a card stands beside the robot: 16 px away, with a tail, and never over the robot, the block it
 * hit or a goal where there is any other place. Pure; CSS pixels of the stage's drawing area.
 */
import type { Box } from "../../canvas/viewport.ts";

export interface CardPlace<Shape extends Size = Size> {
  x: number;
  y: number;
  /** the card's side that the tail leaves from; null where the card stands away from the robot */
  tail: Side | null;
  /** where on that side the tail is, pixels from its start */
  tailAt: number;
  /** the shape that the card has there */
  shape: Shape;
  /** how much of what should stay in sight lies below it; 0 is what is wanted */
  covered: number;
  /** whether there is no place at all that leaves the robot in sight */
  coversRobot: boolean;
}

interface Size {
  width: number;
  height: number;
}

type Side = "left" | "right" | "top" | "bottom";
type Spot = Pick<CardPlace, "x" | "y" | "tail" | "tailAt">;

/** Between the robot and the card. */
const GAP = 16;
/** Between the card and the edges of the stage. */
const EDGE = 8;
/** A tail keeps clear of the card's round corners. */
const CORNER = 24;

/** So many things that should stay in sight are looked past; a maze may be full of goals. */
const LOOKED_PAST = 6;

const ways = ["left", "right", "top", "bottom"] as const;

/**
 * @param areas where the card may stand: the first where that leaves all in sight, then the next
 * @param robot the robot's box
 * @param shapes the sizes that the card can take, the one that is liked best first
 * @param keepClear what the card should not cover besides the robot
 */
export function placeCard<Shape extends Size>(
  areas: readonly Box[],
  robot: Box,
  shapes: readonly Shape[],
  keepClear: readonly Box[],
): CardPlace<Shape> | null {
  return leastCovering(areas, shapes, robot, keepClear, spotsBeside);
}

/**
 * Where a card stands that is not about the place of the robot: in a corner, high up, and as far from the
 * robot as may be, so that the way that it came stays in sight.
 * @param areas whose corners come first, such as the maze's: where that is little larger than the card, only
 *   those of the stage leave the robot and the goal free
 */
export function placeCardAway<Shape extends Size>(
  areas: readonly Box[],
  robot: Box,
  shapes: readonly Shape[],
  keepClear: readonly Box[],
): CardPlace<Shape> | null {
  return leastCovering(areas, shapes, robot, keepClear, (area, card, seen) => {
    const fromLeft = corners(area, card);
    return [
      ...(isFarRight(robot, area) ? fromLeft : [...fromLeft.slice(2), ...fromLeft.slice(0, 2)]),
      ...between(area, [robot, ...seen], card),
    ];
  });
}

function isFarRight(robot: Box, area: Box): boolean {
  return robot.x + robot.width / 2 > area.x + area.width / 2;
}

/** All places around the robot in the order in which they are liked, and then all others. */
function spotsBeside(area: Box, card: Size, seen: readonly Box[], robot: Box): Spot[] {
  const clump = around(robot, seen);
  // The roomier half first: right of a robot that stands on the left, and the other way round.
  const order = isFarRight(robot, area) ? (["right", "left", "top", "bottom"] as const) : ways;
  const sides = [robot, clump].flatMap((from) => order.map((tail) => ({ from, tail })));
  return [
    ...sides.map(({ from, tail }) => beside(tail, area, robot, from, card, null)),
    // Its tail still at the robot, but no longer in its middle.
    ...sides.flatMap(({ from, tail }) =>
      startsBeside(seen, isUpright(tail) ? "y" : "x", card).map((start) =>
        beside(tail, area, robot, from, card, start),
      ),
    ),
    ...corners(area, card),
    ...between(area, [robot, ...seen], card),
  ];
}

/** The first of the places that cover least of what should stay in sight: with a tail, if an area has any. */
function leastCovering<Shape extends Size>(
  areas: readonly Box[],
  shapes: readonly Shape[],
  robot: Box,
  keepClear: readonly Box[],
  spotsIn: (area: Box, card: Size, seen: readonly Box[], robot: Box) => Spot[],
): CardPlace<Shape> | null {
  let best: CardPlace<Shape> | null = null;
  // One that reaches over the edge of its area is the last resort: its end would be out of sight.
  const someFits = areas.some((area) => shapes.some((shape) => fits(shape, area)));
  for (const area of areas) {
    const seen = keepClear.filter((each) => overlap(each, area) > 0).slice(0, LOOKED_PAST);
    let inArea: CardPlace<Shape> | null = null;
    for (const shape of shapes) {
      if (someFits && !fits(shape, area)) continue;
      for (const spot of spotsIn(area, shape, seen, robot)) {
        const covered = coveredBy({ ...spot, ...shape }, robot, keepClear);
        if (inArea === null || isBetter(spot, covered, inArea)) {
          const coversRobot = overlap({ ...spot, ...shape }, robot) > 0;
          inArea = { ...spot, shape, covered, coversRobot };
        }
      }
    }
    if (best === null || (inArea !== null && inArea.covered < best.covered)) best = inArea;
  }
  return best;
}

function fits(card: Size, area: Box): boolean {
  return card.width + 2 * EDGE <= area.width && card.height + 2 * EDGE <= area.height;
}

function isBetter(spot: Spot, covered: number, than: CardPlace): boolean {
  if (covered !== than.covered) return covered < than.covered;
  return than.tail === null && spot.tail !== null;
}

/** The robot counts most. */
function coveredBy(box: Box, robot: Box, keepClear: readonly Box[]): number {
  return 10 * overlap(box, robot) + keepClear.reduce((sum, each) => sum + overlap(box, each), 0);
}

/** The robot with what it touches of what should not be covered: the block that it hit. */
function around(robot: Box, keepClear: readonly Box[]): Box {
  const near = {
    x: robot.x - GAP,
    y: robot.y - GAP,
    width: robot.width + 2 * GAP,
    height: robot.height + 2 * GAP,
  };
  const boxes = [robot, ...keepClear.filter((each) => overlap(each, near) > 0)];
  const x = Math.min(...boxes.map((each) => each.x));
  const y = Math.min(...boxes.map((each) => each.y));
  return {
    x,
    y,
    width: Math.max(...boxes.map((each) => each.x + each.width)) - x,
    height: Math.max(...boxes.map((each) => each.y + each.height)) - y,
  };
}

/**
 * The card beside a box, pushed into the area, its tail at the height of the robot.
 * @param tail the card's side that faces the robot
 * @param start where that side begins; null where the robot is to be in its middle
 */
function beside(
  tail: Side,
  area: Box,
  robot: Box,
  from: Box,
  card: Size,
  start: number | null,
): Spot {
  const middleX = robot.x + robot.width / 2;
  const middleY = robot.y + robot.height / 2;
  const x =
    tail === "left"
      ? from.x + from.width + GAP
      : tail === "right"
        ? from.x - GAP - card.width
        : (start ?? middleX - card.width / 2);
  const y =
    tail === "top"
      ? from.y + from.height + GAP
      : tail === "bottom"
        ? from.y - GAP - card.height
        : (start ?? middleY - card.height / 2);
  const put = pushedInto(area, { x, y }, card);
  const length = isUpright(tail) ? card.height : card.width;
  const at = isUpright(tail) ? middleY - put.y : middleX - put.x;
  const isPushed = isUpright(tail) ? put.x !== x : put.y !== y;
  return {
    ...put,
    tail: isPushed || at < CORNER || at > length - CORNER ? null : tail,
    tailAt: at,
  };
}

function isUpright(side: Side): boolean {
  return side === "left" || side === "right";
}

/** Before and behind each of these, along one axis. */
function startsBeside(boxes: readonly Box[], axis: "x" | "y", card: Size): number[] {
  const length = axis === "x" ? "width" : "height";
  return boxes.flatMap((each) => [
    each[axis] - GAP - card[length],
    each[axis] + each[length] + GAP,
  ]);
}

/** Wherever a card stands close to what it should not cover: if there is room for it, it is at one of these. */
function between(area: Box, boxes: readonly Box[], card: Size): Spot[] {
  const most = { x: area.x + area.width, y: area.y + area.height };
  const xs = [area.x, most.x, ...startsBeside(boxes, "x", card)];
  const ys = [area.y, most.y, ...startsBeside(boxes, "y", card)];
  return xs.flatMap((x) =>
    ys.map((y): Spot => ({ ...pushedInto(area, { x, y }, card), tail: null, tailAt: 0 })),
  );
}

/** A card that is larger than its area begins at the area's start. */
function pushedInto(
  area: Box,
  { x, y }: { x: number; y: number },
  card: Size,
): { x: number; y: number } {
  const within = (value: number, from: number, room: number, length: number) =>
    Math.max(from + EDGE, Math.min(value, from + room - EDGE - length));
  return {
    x: within(x, area.x, area.width, card.width),
    y: within(y, area.y, area.height, card.height),
  };
}

/** Upper and lower left, then upper and lower right. */
function corners(area: Box, card: Size): Spot[] {
  const left = area.x + EDGE;
  const right = Math.max(left, area.x + area.width - EDGE - card.width);
  const top = area.y + EDGE;
  const bottom = Math.max(top, area.y + area.height - EDGE - card.height);
  return [left, right].flatMap((x) =>
    [top, bottom].map((y): Spot => ({ x, y, tail: null, tailAt: 0 })),
  );
}

/** The area that two boxes share. */
export function overlap(a: Box, b: Box): number {
  const width = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
  const height = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
  return width > 0 && height > 0 ? width * height : 0;
}
