/** What claims are checked against: a run tick by tick, and the readings that a sentence names. */
import type { MazeDocument } from "@corridor/maze";
import type { Condition, ProgramDocument } from "@corridor/program";
import type { LineRef, SensorName } from "@corridor/protocol";
import type { PlainMoment } from "./plain-drive.ts";

export interface Evidence {
  maze: MazeDocument;
  program: ProgramDocument;
  moments: readonly PlainMoment[];
  /** tick of the failure */
  end: number;
}

/** The named groups of a sentence. */
export type Found = Readonly<Record<string, string>>;

/** Sentences as regular expressions, and whether the run agrees with what they state. */
export type Claims = readonly (readonly [
  sentence: string,
  holds: (evidence: Evidence, found: Found) => boolean,
])[];

/** Radius of the robot, in units. */
export const RADIUS = 25;
export const DELAYED_NEEDS = 75;
/** An opening is at least one cell deep. A smaller reading is the wall of the corridor. */
export const OPEN = 125;

/** Ticks that are displayed as these seconds, which are cut to tenths. */
export function ticksAt(seconds = ""): number[] {
  const first = Math.ceil(Number(seconds) * 60 - 1e-9);
  return Array.from({ length: 6 }, (_, more) => first + more);
}

/** Ticks at the time of the sentence at which its line chose its action on its readings. */
export function momentsOf({ moments }: Evidence, found: Found): number[] {
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
export function isRead(moment: PlainMoment | undefined, found: Found): boolean {
  if (moment === undefined) return false;
  const { sensors } = moment;
  const named = (["front", "left", "right"] as const).every(
    (name) => found[name] === undefined || isAbout(sensors[name], found[name]),
  );
  const one = found["sensor"] as SensorName | undefined;
  return named && (one === undefined || isAbout(sensors[one], found["reading"]));
}

export function isAbout(value: number, whole?: string): boolean {
  return Math.abs(value - Number(whole)) <= 0.5 + 1e-6;
}

export function lineOf(name = ""): LineRef {
  return name === "“otherwise”" ? "default" : Number(/\d+/.exec(name)?.[0]) - 1;
}

export function conditionOf({ rules }: ProgramDocument, line: LineRef): Condition | null {
  return line === "default" ? null : (rules[line]?.when ?? null);
}

export function isTrueAt(program: ProgramDocument, line: LineRef, moment?: PlainMoment): boolean {
  const when = conditionOf(program, line);
  if (when === null || moment === undefined) return false;
  const { sensors } = moment;
  const right = when.than === "right" ? sensors.right + when.plus : when.than;
  return when.is === ">" ? sensors[when.sensor] > right : sensors[when.sensor] < right;
}
