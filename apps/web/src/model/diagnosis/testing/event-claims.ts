/** Claims about what happened: the failure, what led to it, and which line decided last. */
import type { MazeDocument } from "@corridor/maze";
import type { LineRef } from "@corridor/protocol";
import { who, action, at, reading } from "./claim-patterns.ts";
import {
  DELAYED_NEEDS,
  isAbout,
  lineOf,
  RADIUS,
  ticksAt,
  type Claims,
  type Evidence,
  type Found,
} from "./evidence.ts";
import type { PlainMoment } from "./plain-drive.ts";

export const eventClaims: Claims = [
  ["Bump at (?<at>[\\d.]+) s\\.", ({ moments, end }, { at: time }) => bumpAt(moments, end, time)],
  [
    `The robot started to drive (?<way>forward|back) at (?<at>[\\d.]+) s\\. The wall was ${reading} (?:ahead|behind) then\\.`,
    (evidence, found) => drovePlainly(evidence, found),
  ],
  [
    `${action} drives on first and needs 75 cm ahead\\. Front read ${reading}\\.`,
    (evidence, found) =>
      evidence.moments.some(
        (moment) =>
          moment.action === found["action"] && isAbout(moment.sensors.front, found["reading"]),
      ) && Number(found["reading"]) < DELAYED_NEEDS,
  ],
  [
    `After its turn, ${action} needs (?<needs>\\d+) cm ahead\\. Front read ${reading}\\.`,
    ({ moments }, found) =>
      moments.some(({ sensors }) => isAbout(sensors.front, found["reading"])) &&
      Number(found["reading"]) < Number(found["needs"]),
  ],
  [
    `${who} decided last\\.`,
    ({ moments, end }, found) => decidedLast(moments, end) === lineOf(found["who"]),
  ],
  [
    `${who} decided ${at}\\.`,
    ({ moments, end }, found) =>
      decidedLast(moments, end) === lineOf(found["who"]) &&
      ticksAt(found["at"]).some((tick) => moments[tick]?.line === lineOf(found["who"])),
  ],
  [
    "The robot touched the corner of a block\\. The robot is 50 cm wide, and its beam is thin\\.",
    ({ maze, moments, end }) => touchesCorner(maze, moments[end]) && beamPasses(moments, end),
  ],
  [
    "The goal was not reached in (?<whole>\\d+) s\\.",
    ({ end }, { whole }) => end >= Number(whole) * 60,
  ],
  ["Time is up after (?<whole>\\d+) s\\.", ({ end }, { whole }) => end === Number(whole) * 60],
  [
    "The robot passed here (?<times>\\d+) times in the same direction\\.",
    ({ moments, end }, { times }) => passes(moments, end) === Number(times),
  ],
  [
    "The robot pushes against a wall and gets no further\\.",
    ({ moments, end }) => movedSince(moments, end - 118, end) < 1e-6,
  ],
  [
    "The robot has stayed on this square for 15 s\\.",
    ({ moments, end }) =>
      moments.slice(end - 15 * 60, end + 1).every((each) => cellOf(each) === cellOf(moments[end])),
  ],
  ["The robot visited \\d+ of \\d+ squares(?: in \\d+ s)?\\.", () => true],
];

/** The line of the last decision before the failure. */
function decidedLast(moments: readonly PlainMoment[], end: number): LineRef | null {
  return moments.slice(0, end).findLast(({ line }) => line !== null)?.line ?? null;
}

function bumpAt(moments: readonly PlainMoment[], end: number, seconds?: string): boolean {
  const before = moments[end - 1]?.bumps ?? 0;
  return ticksAt(seconds).includes(end) && (moments[end]?.bumps ?? 0) > before;
}

/**
 * Whether the robot drove straight from the tick to the bump, and no line drove it so one tick
 * earlier.
 */
function drovePlainly({ moments, end }: Evidence, found: Found): boolean {
  const side = found["way"] === "back" ? "back" : "front";
  const isDriving = (tick: number): boolean => {
    const [one, next] = [moments[tick], moments[tick + 1]];
    if (one === undefined || next === undefined || Math.abs(one.heading - next.heading) > 1e-9)
      return false;
    const way = (one.heading * Math.PI) / 180;
    const along = (next.x - one.x) * Math.sin(way) - (next.y - one.y) * Math.cos(way);
    return side === "front" ? along > 1e-9 : along < -1e-9;
  };
  return ticksAt(found["at"]).some((tick) => {
    const begun = moments[tick];
    if (begun === undefined || tick >= end || !isAbout(begun.sensors[side], found["reading"]))
      return false;
    // A delayed turn drives by itself; the decision after it counts.
    if (tick > 0 && moments[tick - 1]?.line !== null && isDriving(tick - 1)) return false;
    for (let each = tick; each < end - 1; each++) if (!isDriving(each)) return false;
    return true;
  });
}

/** Whether a corner of a block is one radius from the robot's centre. */
function touchesCorner({ blocks }: MazeDocument, robot: PlainMoment | undefined): boolean {
  if (robot === undefined) return false;
  const { x, y } = robot;
  return blocks.some((row, at) =>
    Array.from({ length: row.length }, (_, column) => column).some((column) => {
      if (row[column] !== "#") return false;
      return [0, 1].some((right) =>
        [0, 1].some((down) => {
          const away = Math.hypot((column + right) * 100 - x, (at + down) * 100 - y);
          return Math.abs(away - RADIUS) < 0.5;
        }),
      );
    }),
  );
}

/** Whether the beam in the driving direction reads more than what the robot touches. */
function beamPasses(moments: readonly PlainMoment[], end: number): boolean {
  const driven = moments.slice(0, end).findLast(({ action }) => action !== null);
  const side = driven?.action === "reverse" ? "back" : "front";
  return (moments[end]?.sensors[side] ?? 0) > RADIUS + 1;
}

/** How often, up to a tick, the robot moved between the same two cells as in that tick. */
function passes(moments: readonly PlainMoment[], end: number): number {
  const way = (tick: number) => `${cellOf(moments[tick - 1])} to ${cellOf(moments[tick])}`;
  if (cellOf(moments[end - 1]) === cellOf(moments[end])) return 0;
  const all = Array.from({ length: end }, (_, at) => way(at + 1));
  return all.filter((each) => each === way(end)).length;
}

function movedSince(moments: readonly PlainMoment[], from: number, to: number): number {
  const [one, other] = [moments[from], moments[to]];
  if (one === undefined || other === undefined) return Infinity;
  return Math.hypot(one.x - other.x, one.y - other.y);
}

function cellOf(moment?: PlainMoment): string {
  if (moment === undefined) return "none";
  return `${Math.floor(moment.x / 100)},${Math.floor(moment.y / 100)}`;
}
