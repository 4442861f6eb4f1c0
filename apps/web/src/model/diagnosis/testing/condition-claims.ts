/** Claims about when the condition of a line was true, and what is wrong with it. */
import type { SensorName } from "@corridor/protocol";
import { who, inner, at, sensor, along, number, reading, read, sides } from "./claim-patterns.ts";
import {
  conditionOf,
  isRead,
  isTrueAt,
  lineOf,
  ticksAt,
  type Claims,
  type Evidence,
  type Found,
} from "./evidence.ts";

export const conditionClaims: Claims = [
  [
    `${who} was true ${at} ${read}, but ${inner} above it decided\\. The first true line wins\\.`,
    (evidence, found) =>
      ticksAt(found["at"]).some((tick) => {
        const moment = evidence.moments[tick];
        const [line, above] = [lineOf(found["who"]), lineOf(found["inner"])];
        return (
          moment?.line === above &&
          Number(above) < Number(line) &&
          isTrueAt(evidence.program, line, moment) &&
          isRead(moment, found)
        );
      }),
  ],
  [
    `${who} comes about (?<by>\\d+) cm too late\\. At (?<at>[\\d.]+) s, when ${along} was ${reading}, it was not yet true\\.`,
    (evidence, found) => {
      const line = lineOf(found["who"]);
      return (
        ticksAt(found["at"]).some((tick) => {
          const moment = evidence.moments[tick];
          return (
            moment !== undefined &&
            isRead(moment, found) &&
            !isTrueAt(evidence.program, line, moment)
          );
        }) && isReadAfter(evidence, found, true) === true
      );
    },
  ],
  [
    `${who} was still true ${at}, when ${along} was ${reading}\\. It was true for about (?<by>\\d+) cm too long\\.`,
    (evidence, found) =>
      wasBefore(evidence, found, true) && isReadAfter(evidence, found, false) !== false,
  ],
  [
    `${who} was no longer true ${at}, when ${along} was ${reading}\\. It stopped being true about (?<by>\\d+) cm too early\\.`,
    (evidence, found) => wasBefore(evidence, found, false),
  ],
  [
    `${who} compares left with right\\. At (?<at>[\\d.]+) s, left was (?<left>${number}) cm and right was (?<right>${number}) cm\\. Its number is wrong there\\.`,
    ({ moments }, found) => ticksAt(found["at"]).some((tick) => isRead(moments[tick], found)),
  ],
  [
    `${who} is always true\\. No sensor reads less than 25 cm\\. One block is 100 cm\\.`,
    ({ program, moments }, found) =>
      moments.every((moment) => isTrueAt(program, lineOf(found["who"]), moment)),
  ],
  [
    `${who} was needed ${at}, when ${sensor} was ${reading}, but it was not true\\. Its number is off by about (?<by>\\d+) cm\\.`,
    ({ program, moments }, found) =>
      ticksAt(found["at"]).some((tick) => {
        const moment = moments[tick];
        if (moment === undefined || !isRead(moment, found)) return false;
        return !isTrueAt(program, lineOf(found["who"]), moment);
      }),
  ],
  [
    `${who} was true ${at}, when ${sensor} was ${reading}\\. Its number is off by about (?<by>\\d+) cm\\.`,
    ({ program, moments }, found) =>
      ticksAt(found["at"]).some((tick) => {
        const moment = moments[tick];
        if (moment === undefined || !isRead(moment, found)) return false;
        return isTrueAt(program, lineOf(found["who"]), moment);
      }),
  ],
  [
    `${who} never decided\\. It was needed ${at}, when ${sensor} was ${reading}\\.`,
    ({ moments }, found) =>
      !moments.some(({ line }) => line === lineOf(found["who"])) &&
      ticksAt(found["at"]).some((tick) => isRead(moments[tick], found)),
  ],
  [
    `${who} was (?<not>not )?true ${at} ${read}\\. Its sign, “(?<sign>[<>])”, points the wrong way\\.`,
    ({ program, moments }, found) => {
      const line = lineOf(found["who"]);
      const when = conditionOf(program, line);
      return (
        when?.is === found["sign"] &&
        ticksAt(found["at"]).some((tick) => {
          const moment = moments[tick];
          if (moment === undefined || !isRead(moment, found)) return false;
          return isTrueAt(program, line, moment) === (found["not"] === undefined);
        })
      );
    },
  ],
  [
    `${who} uses ${sensor}\\. Another sensor is needed ${at} ${sides}\\.`,
    ({ program, moments }, { who: line, sensor: asked, ...found }) =>
      conditionOf(program, lineOf(line))?.sensor === asked &&
      ticksAt(found["at"]).some((tick) => isRead(moments[tick], found)),
  ],
];

/** Whether the line decided one tick before the moment, and then is still true, or no longer. */
function wasBefore({ program, moments }: Evidence, found: Found, isStill: boolean): boolean {
  const line = lineOf(found["who"]);
  return ticksAt(found["at"]).some((tick) => {
    const moment = moments[tick];
    if (moment === undefined || !isRead(moment, found)) return false;
    return moments[tick - 1]?.line === line && isTrueAt(program, line, moment) === isStill;
  });
}

/**
 * Whether the line becomes true, or false, as many cm after the moment as the sentence states,
 * within 5 cm. Null if it never does.
 */
function isReadAfter(
  { program, moments }: Evidence,
  found: Found,
  isTrue: boolean,
): boolean | null {
  const line = lineOf(found["who"]);
  const [first = 0] = ticksAt(found["at"]);
  const changes = moments.slice(first).find((each) => isTrueAt(program, line, each) === isTrue);
  if (changes === undefined) return null;
  const reading = changes.sensors[found["sensor"] as SensorName];
  const away = Math.abs(reading - Number(found["reading"]));
  return Math.abs(away - Number(found["by"])) <= 5;
}
