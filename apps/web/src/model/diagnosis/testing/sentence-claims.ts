/**
 * Parses the English sentences of a diagnosis and checks each one against the run: lines, times,
 * readings, distances. A sentence without a claim is reported as unknown.
 */
import type { MazeDocument } from "@corridor/maze";
import type { Condition, ProgramDocument } from "@corridor/program";
import type { LineRef, SensorName } from "@corridor/protocol";
import { plainDrive, type PlainMoment } from "./plain-drive.ts";

interface Evidence {
  maze: MazeDocument;
  program: ProgramDocument;
  moments: readonly PlainMoment[];
  /** tick of the failure */
  end: number;
}

type Claim = (evidence: Evidence, found: Readonly<Record<string, string>>) => boolean;

const who = "(?<who>[Ll]ine \\d+|“otherwise”)";
const inner = "(?<inner>line \\d+|“otherwise”)";
const action = "“(?<action>[a-z 0-9]+)”";
const at = "at (?<at>[\\d.]+) s";
const sensor = "(?<sensor>front|back|left|right)";
/**
 * Sensors for a distance along the path. Driving on brings the robot no nearer to what is beside
 * it.
 */
const along = "(?<sensor>front|back)";
const number = "\\d+(?:\\.\\d+)?";
const reading = `(?<reading>${number}) cm`;
const read = `\\((?:${sensor}: ${reading}|left: (?<left>${number}) cm, right: (?<right>${number}) cm)\\)`;
const sides = `\\(front: (?<front>${number}) cm, left: (?<left>${number}) cm, right: (?<right>${number}) cm\\)`;

/** Radius of the robot, in units. */
const RADIUS = 25;
const DELAYED_NEEDS = 75;
/** An opening is at least one cell deep. A smaller reading is the wall of the corridor. */
const OPEN = 125;

const claims: readonly (readonly [sentence: string, holds: Claim])[] = [
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
    `${who} chose ${action} ${at}, when ${along} was ${reading}\\. That was about (?<by>\\d+) cm too early\\.`,
    (evidence, found) => {
      const is = conditionOf(evidence.program, lineOf(found["who"]))?.is;
      const right = Number(found["reading"]) + Number(found["by"]) * (is === "<" ? -1 : 1);
      // The robot must be able to stand at the better number.
      return momentsOf(evidence, found).length > 0 && right > RADIUS;
    },
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
  [
    `${who} uses ${sensor}\\. Another sensor is needed ${at} ${sides}\\.`,
    ({ program, moments }, { who: line, sensor: asked, ...found }) =>
      conditionOf(program, lineOf(line))?.sensor === asked &&
      ticksAt(found["at"]).some((tick) => isRead(moments[tick], found)),
  ],
];

const readers = claims.map(([sentence, holds]) => ({
  sentence: new RegExp(`^${sentence}(?: |$)`, "u"),
  holds,
}));

/**
 * @param text in English, without the number of a maze
 * @param end tick of the failure
 * @returns the sentences that the run contradicts, and the text from the first unknown sentence on
 */
export function falseSentences(
  maze: MazeDocument,
  program: ProgramDocument,
  text: string,
  end: number,
): string[] {
  const evidence = { maze, program, moments: plainDrive(maze, program, end), end };
  const wrong: string[] = [];
  let rest = text;
  while (rest !== "") {
    const reader = readers.find(({ sentence }) => sentence.test(rest));
    const match = reader?.sentence.exec(rest);
    if (reader === undefined || match === null || match === undefined)
      return [...wrong, `unknown: ${rest}`];
    const found = match.groups ?? {};
    const isFalse = !reader.holds(evidence, found) || contradictsLine(evidence, found);
    if (isFalse) wrong.push(match[0].trim());
    rest = rest.slice(match[0].length);
  }
  return wrong;
}

/** Ticks that are displayed as these seconds, which are cut to tenths. */
function ticksAt(seconds = ""): number[] {
  const first = Math.ceil(Number(seconds) * 60 - 1e-9);
  return Array.from({ length: 6 }, (_, more) => first + more);
}

/** The line of the last decision before the failure. */
function decidedLast(moments: readonly PlainMoment[], end: number): LineRef | null {
  return moments.slice(0, end).findLast(({ line }) => line !== null)?.line ?? null;
}

function bumpAt(moments: readonly PlainMoment[], end: number, seconds?: string): boolean {
  const before = moments[end - 1]?.bumps ?? 0;
  return ticksAt(seconds).includes(end) && (moments[end]?.bumps ?? 0) > before;
}

/**
 * Whether the numbers of the sentence contradict the condition of a line that it names. Example:
 * "right was 50 cm" for a `right > 50` that was true.
 */
function contradictsLine(
  { program, moments }: Evidence,
  found: Readonly<Record<string, string>>,
): boolean {
  const ticks = ticksAt(found["at"]).filter((tick) => isRead(moments[tick], found));
  return [found["who"], found["inner"]].some((name) => {
    const when = name === undefined ? null : conditionOf(program, lineOf(name));
    if (when === null) return false;
    const read = (sensor: SensorName) =>
      found["sensor"] === sensor ? found["reading"] : sensor === "back" ? undefined : found[sensor];
    const left = read(when.sensor);
    const other = when.than === "right" ? read("right") : "0";
    if (left === undefined || other === undefined) return false;
    const right = when.than === "right" ? Number(other) + when.plus : when.than;
    const reads = when.is === ">" ? Number(left) > right : Number(left) < right;
    return ticks.every((tick) => isTrueAt(program, lineOf(name), moments[tick]) !== reads);
  });
}

/** Ticks at the time of the sentence at which its line chose its action on its readings. */
function momentsOf({ moments }: Evidence, found: Readonly<Record<string, string>>): number[] {
  return ticksAt(found["at"]).filter((tick) => {
    const moment = moments[tick];
    return (
      moment?.line === lineOf(found["who"]) &&
      moment.action === found["action"] &&
      isRead(moment, found)
    );
  });
}

/** Whether the moment has all readings of the sentence. */
function isRead(moment: PlainMoment | undefined, found: Readonly<Record<string, string>>): boolean {
  if (moment === undefined) return false;
  const { sensors } = moment;
  const named = (["front", "left", "right"] as const).every(
    (name) => found[name] === undefined || isAbout(sensors[name], found[name]),
  );
  const one = found["sensor"] as SensorName | undefined;
  return named && (one === undefined || isAbout(sensors[one], found["reading"]));
}

function isAbout(value: number, whole?: string): boolean {
  return Math.abs(value - Number(whole)) <= 0.5 + 1e-6;
}

function lineOf(name = ""): LineRef {
  return name === "“otherwise”" ? "default" : Number(/\d+/.exec(name)?.[0]) - 1;
}

function conditionOf({ rules }: ProgramDocument, line: LineRef): Condition | null {
  return line === "default" ? null : (rules[line]?.when ?? null);
}

function isTrueAt(program: ProgramDocument, line: LineRef, moment?: PlainMoment): boolean {
  const when = conditionOf(program, line);
  if (when === null || moment === undefined) return false;
  const { sensors } = moment;
  const right = when.than === "right" ? sensors.right + when.plus : when.than;
  return when.is === ">" ? sensors[when.sensor] > right : sensors[when.sensor] < right;
}

/** Whether the line decided one tick before the moment, and then is still true, or no longer. */
function wasBefore(
  { program, moments }: Evidence,
  found: Readonly<Record<string, string>>,
  isStill: boolean,
): boolean {
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
  found: Readonly<Record<string, string>>,
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

/** How often, up to a tick, the robot moved between the same two cells as in that tick. */
function passes(moments: readonly PlainMoment[], end: number): number {
  const way = (tick: number) => `${cellOf(moments[tick - 1])} to ${cellOf(moments[tick])}`;
  if (cellOf(moments[end - 1]) === cellOf(moments[end])) return 0;
  const all = Array.from({ length: end }, (_, at) => way(at + 1));
  return all.filter((each) => each === way(end)).length;
}

function cellOf(moment?: PlainMoment): string {
  if (moment === undefined) return "none";
  return `${Math.floor(moment.x / 100)},${Math.floor(moment.y / 100)}`;
}

function movedSince(moments: readonly PlainMoment[], from: number, to: number): number {
  const [one, other] = [moments[from], moments[to]];
  if (one === undefined || other === undefined) return Infinity;
  return Math.hypot(one.x - other.x, one.y - other.y);
}

/**
 * Whether the side has just opened: at most about 20 units earlier, with the same heading, it was
 * not open.
 */
function isEdge(
  { moments }: Evidence,
  tick: number,
  found: Readonly<Record<string, string>>,
): boolean {
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

/**
 * Whether the robot drove straight from the tick to the bump, and no line drove it so one tick
 * earlier.
 */
function drovePlainly(
  { moments, end }: Evidence,
  found: Readonly<Record<string, string>>,
): boolean {
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
