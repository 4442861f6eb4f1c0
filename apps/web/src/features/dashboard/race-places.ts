/** Places the robots of a race beside each other, so that no robot hides another one. Pure. */

/** Radius of a robot that races alone, in cells. */
const ALONE = 0.3;
/** Of the circle on which few robots are, around their pose, and of those robots. */
const FEW = { lane: 0.23, radius: 0.21 };
const MOST_FEW = 5;
/** Of the area that many robots fill like the seeds of a sunflower. */
const AREA = 0.4;
const GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

export interface RacePlace {
  /** from the pose of the robot, in cells */
  x: number;
  y: number;
  /** of the robot, in cells */
  radius: number;
}

/** Where to draw each of `count` robots that have one pose: all within its cell. */
export function racePlaces(count: number): RacePlace[] {
  if (count === 1) return [{ x: 0, y: 0, radius: ALONE }];
  const isFew = count <= MOST_FEW;
  return Array.from({ length: count }, (_, at) => {
    const angle = isFew ? (2 * Math.PI * at) / count : GOLDEN_ANGLE * at;
    const lane = isFew ? FEW.lane : AREA * Math.sqrt((at + 0.5) / count);
    const radius = isFew ? FEW.radius : AREA / Math.sqrt(count);
    return { x: -lane * Math.cos(angle), y: -lane * Math.sin(angle), radius };
  });
}
