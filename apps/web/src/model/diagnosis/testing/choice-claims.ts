/** Claims about what a line chose, and about choices that no line made. */
import type { LineRef, SensorName } from "@corridor/protocol";
import { who, inner, action, at, sensor, along, number, reading, sides } from "./claim-patterns.ts";
import {
  conditionOf,
  DELAYED_NEEDS,
  isAbout,
  isRead,
  isTrueAt,
  lineOf,
  momentsOf,
  OPEN,
  RADIUS,
  ticksAt,
  type Claims,
  type Evidence,
  type Found,
} from "./evidence.ts";
import type { PlainMoment } from "./plain-drive.ts";

export const choiceClaims: Claims = [
  [
    `${who} chose ${action} ${at}, at the edge of the opening \\(${sensor}: ${reading}\\)\\. A delayed turn drives on for 50 cm first\\.`,
    (evidence, found) => momentsOf(evidence, found).some((tick) => isEdge(evidence, tick, found)),
  ],
  [
    `${who} chose ${action} ${at}\\. That was too early here\\. A delayed turn drives on for 50 cm first\\.`,
    (evidence, found) => momentsOf(evidence, found).length > 0,
  ],
  [
    `${who} chose ${action} ${at} with (?<front>${number}) cm in front\\. It drives on first and needs 75 cm\\.`,
    (evidence, found) =>
      momentsOf(evidence, found).length > 0 &&
      Number(found["front"]) < DELAYED_NEEDS &&
      found["action"]?.startsWith("delayed") === true,
  ],
  [
    `${who} chose ${action} ${at}\\. It drives on first, and that was too late here\\. A turn without a delay starts at once\\.`,
    (evidence, found) => momentsOf(evidence, found).length > 0,
  ],
  [
    `${who} chose ${action} ${at}, when ${along} was ${reading}\\. That was about (?<by>\\d+) cm too early\\.`,
    (evidence, found) => {
      const is = conditionOf(evidence.program, lineOf(found["who"]))?.is;
      const right = Number(found["reading"]) + Number(found["by"]) * (is === "<" ? -1 : 1);
      // The robot must be able to stand at the better number.
      return momentsOf(evidence, found).length > 0 && right > RADIUS;
    },
  ],
  [
    `${who} chose ${action} ${at} and turned to a wall \\(${sensor}: ${reading}\\)\\. There was room on another side \\((?<open>front|left|right): (?<free>${number}) cm\\)\\.`,
    (evidence, found) =>
      momentsOf(evidence, found).some((tick) => {
        const moment = evidence.moments[tick];
        const open = found["open"] as SensorName;
        return moment !== undefined && isAbout(moment.sensors[open], found["free"]);
      }) &&
      found["action"]?.includes(found["sensor"] ?? "-") === true &&
      Number(found["reading"]) <= DELAYED_NEEDS &&
      Number(found["free"]) >= OPEN,
  ],
  [
    `${who} drives back and ${inner} drives forward, again and again\\. Each undoes the other\\. Try a turn\\.`,
    ({ moments }, found) => {
      const back = starts(moments, lineOf(found["who"]), "reverse");
      return back > 2 && starts(moments, lineOf(found["inner"]), "forward") > 2;
    },
  ],
  [
    `${who} chose ${action} ${at} ${sides}\\. It needs another action\\.`,
    (evidence, found) => momentsOf(evidence, found).length > 0,
  ],
  [
    `At (?<at>[\\d.]+) s, the wall was (?<wall>${number}) cm (?<way>ahead|behind), and ${inner} chose ${action}\\. A line for this place is missing\\.`,
    (evidence, { wall, way, inner: line, ...found }) =>
      Number(wall) <= 50 &&
      momentsOf(evidence, {
        ...found,
        who: line ?? "",
        sensor: way === "ahead" ? "front" : "back",
        reading: wall ?? "",
      }).length > 0,
  ],
  [
    `At (?<at>[\\d.]+) s, ${sensor} was ${reading}, and no line turns (?<side>left|right)\\.`,
    ({ program, moments }, found) =>
      ticksAt(found["at"]).some((tick) => isRead(moments[tick], found)) &&
      found["side"] === found["sensor"] &&
      ![
        program.default,
        ...program.rules.flatMap(({ when, do: it }) => (when === null ? [] : [it])),
      ].some((each) => each.endsWith(`${found["side"]} 90`)),
  ],
  [
    `At (?<at>[\\d.]+) s, ${sensor} was ${reading}, and ${inner} chose ${action}\\. A line for this place is missing\\.`,
    (evidence, { inner: line, ...found }) =>
      momentsOf(evidence, { ...found, who: line ?? "" }).length > 0,
  ],
  [
    `At (?<at>[\\d.]+) s, ${sensor} was ${reading}, and ${inner} chose ${action}\\. No line above it drives forward there\\.`,
    (evidence, { inner: line, ...found }) => {
      if (found["sensor"] !== "front" || Number(found["reading"]) < 50) return false;
      const at = lineOf(line);
      const rules = at === "default" ? evidence.program.rules : evidence.program.rules.slice(0, at);
      return momentsOf(evidence, { ...found, who: line ?? "" }).some((tick) =>
        rules.every(
          ({ do: action }, above) =>
            action !== "forward" || !isTrueAt(evidence.program, above, evidence.moments[tick]),
        ),
      );
    },
  ],
  [
    `${who} chose ${action} ${at}\\. Without this line, the robot gets past this place\\.`,
    (evidence, found) => momentsOf(evidence, found).length > 0,
  ],
];

/**
 * Whether the side has just opened: at most about 20 units earlier, with the same heading, it was
 * not open.
 */
function isEdge({ moments }: Evidence, tick: number, found: Found): boolean {
  const here = moments[tick];
  const side = found["sensor"] as SensorName;
  if (here === undefined || here.sensors[side] < OPEN) return false;
  for (let at = tick; at >= 0; at--) {
    const earlier = moments[at];
    if (earlier === undefined || Math.abs(earlier.heading - here.heading) > 1) return false;
    const away = Math.abs(earlier.x - here.x) + Math.abs(earlier.y - here.y);
    if (earlier.sensors[side] < OPEN) return true;
    if (away > 20) return false;
  }
  return false;
}

/** How often the line started this action. */
function starts(moments: readonly PlainMoment[], line: LineRef, action: string): number {
  return moments.filter(
    (moment, at) =>
      moment.line === line && moment.action === action && moments[at - 1]?.line !== line,
  ).length;
}
