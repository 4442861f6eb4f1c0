/**
 * Places a card beside the robot: 16 px away, with a tail. The card covers the robot, the block
 * that it hit or a goal only if no other place exists. Pure functions; all lengths are in CSS
 * pixels of the stage's drawing area.
 */
import type { Box } from "../../stage/drawing/viewport.ts";

export interface CardPlace<Shape extends Size = Size> {
  x: number;
  y: number;
  /**
   * the side of the card from which the tail points; null if the card stands away from the robot
   */
  tail: Side | null;
  /** position of the tail on that side, in pixels from its start */
  tailAt: number;
  /** the shape of the card at this place */
  shape: Shape;
  /** covered area of the boxes that should stay visible, the robot weighted tenfold; 0 is ideal */
  covered: number;
  /** whether the card covers a part of the robot */
  coversRobot: boolean;
  /** whether the card is larger than every area, so that its end is out of sight */
  isCut: boolean;
}

interface Size {
  width: number;
  height: number;
}

type Side = "left" | "right" | "top" | "bottom";
type Spot = Pick<CardPlace, "x" | "y" | "tail" | "tailAt">;

/** Distance from the robot and from other boxes. */
const GAP = 16;
/** Distance from the edges of the area. */
const EDGE = 8;
/** Distance of the tail from the ends of its side, which have round corners. */
const CORNER = 24;

/**
 * Largest number of `keepClear` boxes that create candidate places; a maze may be full of goals.
 */
const LOOKED_PAST = 6;

const ways = ["left", "right", "top", "bottom"] as const;

/**
 * @param areas areas in order of preference; a later area counts only if the card covers less in it
 * @param robot the robot's box
 * @param shapes sizes of the card, in order of preference
 * @param keepClear boxes besides the robot that the card should not cover
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
 * Places a card that does not point at the robot. It stands high up in a corner, far from the
 * robot, so that the trail stays visible.
 * If the maze is little larger than the card, only the corners of the stage leave the robot and the
 * goal visible.
 * @param areas areas in order of preference, such as the maze before the stage
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

/** Returns the candidate places in order of preference: around the robot first, then all others. */
function spotsBeside(area: Box, card: Size, seen: readonly Box[], robot: Box): Spot[] {
  const clump = around(robot, seen);
  // The half with more room comes first: the right half if the robot is on the left, and vice
  // versa.
  const order = isFarRight(robot, area) ? (["right", "left", "top", "bottom"] as const) : ways;
  const sides = [robot, clump].flatMap((from) => order.map((tail) => ({ from, tail })));
  return [
    ...sides.map(({ from, tail }) => beside(tail, area, robot, from, card, null)),
    // The tail still points at the robot, but not from the middle of the card.
    ...sides.flatMap(({ from, tail }) =>
      startsBeside(seen, isUpright(tail) ? "y" : "x", card).map((start) =>
        beside(tail, area, robot, from, card, start),
      ),
    ),
    ...corners(area, card),
    ...between(area, [robot, ...seen], card),
  ];
}

/**
 * Returns the first of the places that cover least. Within an area, a place with a tail wins over
 * an equal place without one.
 */
function leastCovering<Shape extends Size>(
  areas: readonly Box[],
  shapes: readonly Shape[],
  robot: Box,
  keepClear: readonly Box[],
  spotsIn: (area: Box, card: Size, seen: readonly Box[], robot: Box) => Spot[],
): CardPlace<Shape> | null {
  let best: CardPlace<Shape> | null = null;
  // A shape that exceeds its area is the last resort, because its end would be out of sight.
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
          inArea = { ...spot, shape, covered, coversRobot, isCut: !someFits };
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

function coveredBy(box: Box, robot: Box, keepClear: readonly Box[]): number {
  return 10 * overlap(box, robot) + keepClear.reduce((sum, each) => sum + overlap(box, each), 0);
}

/** Bounding box of the robot and the boxes next to it, such as the block that it hit. */
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
 * Places the card beside a box and moves it into the area, with the tail at the robot.
 * @param tail the side of the card that faces the robot
 * @param start where that side starts; null centres the card on the robot
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

/** Start positions before and after each box, along one axis. */
function startsBeside(boxes: readonly Box[], axis: "x" | "y", card: Size): number[] {
  const length = axis === "x" ? "width" : "height";
  return boxes.flatMap((each) => [
    each[axis] - GAP - card[length],
    each[axis] + each[length] + GAP,
  ]);
}

/**
 * Candidate places next to the boxes and at the edges of the area. If the area has room for the
 * card beside the boxes, at least one of these places has it.
 */
function between(area: Box, boxes: readonly Box[], card: Size): Spot[] {
  const most = { x: area.x + area.width, y: area.y + area.height };
  const xs = [area.x, most.x, ...startsBeside(boxes, "x", card)];
  const ys = [area.y, most.y, ...startsBeside(boxes, "y", card)];
  return xs.flatMap((x) =>
    ys.map((y): Spot => ({ ...pushedInto(area, { x, y }, card), tail: null, tailAt: 0 })),
  );
}

/** A card that is larger than its area starts at the start of the area. */
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

/** Upper left, lower left, upper right, lower right. */
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
