/**
 * Where a card stands beside the robot: 16 px away, with a tail, and never over the robot, the block it
 * hit or a goal where there is any other place. Pure; CSS pixels of the stage's drawing area.
 */
import type { Box } from "../../canvas/viewport.ts";

export interface CardPlace {
  x: number;
  y: number;
  /** the card's side that the tail leaves from; null where the card stands away from the robot */
  tail: "left" | "right" | "top" | "bottom" | null;
  /** where on that side the tail is, pixels from its start */
  tailAt: number;
}

/** Between the robot and the card. */
const GAP = 16;
/** Between the card and the edges of the stage. */
const EDGE = 8;
/** A tail keeps clear of the card's round corners. */
const CORNER = 24;

const ways = ["left", "right", "top", "bottom"] as const;

/**
 * @param areas where the card may stand: the first where that leaves all in sight, then the next
 * @param robot the robot's box
 * @param card the size that the card takes
 * @param keepClear what the card should not cover besides the robot
 */
export function placeCard(
  areas: readonly Box[],
  robot: Box,
  card: { width: number; height: number },
  keepClear: readonly Box[],
): CardPlace {
  const clump = around(robot, keepClear);
  const places = areas.flatMap((area) => {
    // The roomier half first: right of a robot that stands on the left, and the other way round.
    const order = isFarRight(robot, area) ? (["right", "left", "top", "bottom"] as const) : ways;
    return [
      ...order.map((tail) => beside(tail, area, robot, robot, card)),
      ...order.map((tail) => beside(tail, area, robot, clump, card)),
      ...corners(area, card),
    ];
  });
  return leastCovering(places, robot, card, keepClear);
}

/**
 * Where a card stands that is not about the place of the robot: in a corner, high up, and as far from the
 * robot as may be, so that the way that it came stays in sight.
 * @param areas whose corners come first, such as the maze's: where that is little larger than the card, only
 *   those of the stage leave the robot and the goal free
 */
export function placeCardAway(
  areas: readonly Box[],
  robot: Box,
  card: { width: number; height: number },
  keepClear: readonly Box[],
): CardPlace {
  const places = areas.flatMap((area) => {
    const fromLeft = corners(area, card);
    return isFarRight(robot, area) ? fromLeft : [...fromLeft.slice(2), ...fromLeft.slice(0, 2)];
  });
  return leastCovering(places, robot, card, keepClear);
}

function isFarRight(robot: Box, area: Box): boolean {
  return robot.x + robot.width / 2 > area.x + area.width / 2;
}

/** The first of the places that cover least of what should stay in sight. */
function leastCovering(
  places: readonly CardPlace[],
  robot: Box,
  card: { width: number; height: number },
  keepClear: readonly Box[],
): CardPlace {
  let best: CardPlace | undefined;
  let least = Number.POSITIVE_INFINITY;
  for (const place of places) {
    const box = { x: place.x, y: place.y, ...card };
    const covered =
      10 * overlap(box, robot) + keepClear.reduce((sum, each) => sum + overlap(box, each), 0);
    if (covered < least) {
      least = covered;
      best = place;
    }
  }
  return best ?? { x: 0, y: 0, tail: null, tailAt: 0 };
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
 * The card beside a box, pushed into the area, its tail at the height of the robot. `tail` is the card's
 * side that faces the robot.
 */
function beside(
  tail: "left" | "right" | "top" | "bottom",
  area: Box,
  robot: Box,
  from: Box,
  card: { width: number; height: number },
): CardPlace {
  const middleX = robot.x + robot.width / 2;
  const middleY = robot.y + robot.height / 2;
  const isBeside = tail === "left" || tail === "right";
  const x = isBeside
    ? tail === "left"
      ? from.x + from.width + GAP
      : from.x - GAP - card.width
    : middleX - card.width / 2;
  const y = isBeside
    ? middleY - card.height / 2
    : tail === "top"
      ? from.y + from.height + GAP
      : from.y - GAP - card.height;
  const inX = within(x, area.x + EDGE, area.x + area.width - EDGE - card.width);
  const inY = within(y, area.y + EDGE, area.y + area.height - EDGE - card.height);
  const length = isBeside ? card.height : card.width;
  const at = isBeside ? middleY - inY : middleX - inX;
  const isPushed = isBeside ? inX !== x : inY !== y;
  return {
    x: inX,
    y: inY,
    tail: isPushed || at < CORNER || at > length - CORNER ? null : tail,
    tailAt: at,
  };
}

/** Upper and lower left, then upper and lower right. */
function corners(area: Box, card: { width: number; height: number }): CardPlace[] {
  const left = area.x + EDGE;
  const right = Math.max(left, area.x + area.width - EDGE - card.width);
  const top = area.y + EDGE;
  const bottom = Math.max(top, area.y + area.height - EDGE - card.height);
  return [left, right].flatMap((x) =>
    [top, bottom].map((y): CardPlace => ({ x, y, tail: null, tailAt: 0 })),
  );
}

/** A card that is larger than its area begins at the area's start. */
function within(value: number, least: number, most: number): number {
  return Math.max(least, Math.min(value, most));
}

function overlap(a: Box, b: Box): number {
  const width = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
  const height = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
  return width > 0 && height > 0 ? width * height : 0;
}
