/** Checks every claim of a diagnosis against a plain run. */
import type { MazeDocument } from "@corridor/maze";
import { numberOf, evaluateCondition, type ProgramDocument } from "@corridor/program";
import type { SensorReadings } from "@corridor/protocol";
import { applyFix } from "../../apply-fix.ts";
import { causeLine, type Cause, type Diagnosis, type WrongNumber } from "../diagnosis.ts";
import { actionIn, plainRun, squareOf, switchedRun, type PlainTick } from "./plain-run.ts";

/** Equal runs have exactly equal readings. */
const sameReadings = (a: SensorReadings, b: SensorReadings | undefined): boolean =>
  JSON.stringify(a) === JSON.stringify(b);

/**
 * @param goalBy the last tick at which a fix may reach the goal, if the failure was not a bump
 * @returns the false claims
 */
export function falseClaims(
  maze: MazeDocument,
  program: ProgramDocument,
  diagnosis: Diagnosis,
  goalBy: number,
): string[] {
  const { event, cause, fixes } = diagnosis;
  const ticks = plainRun(maze, program, event.tick);
  const wrong: string[] = [];
  const claim = (name: string, holds: boolean) => {
    if (!holds) wrong.push(name);
  };
  if (event.kind === "bump") {
    claim("a motion that needs room had less", hadLess(event));
    const last = ticks[event.tick - 1];
    const before = ticks[event.tick - 2];
    claim("a bump at this tick", (last?.bumps ?? 0) === (before?.bumps ?? 0) + 1);
    const decided = ticks.findLast(({ line }) => line !== null);
    claim("the line that drove", decided?.line === event.line);
    const begun = ticks[event.startedAt]?.readings[event.side];
    claim("the reading as the motion began", begun === event.reading);
    const { x = 0, y = 0 } = last ?? {};
    const away = Math.sqrt((event.contact.x - x) ** 2 + (event.contact.y - y) ** 2);
    claim("the touched point is 25 cm from the centre", Math.abs(away - 25) < 0.5);
  }
  claim("fixes and cause come together", (cause === null) === (fixes.length === 0));
  if (cause === null) return wrong;
  const { moment } = cause;
  const at = ticks[moment.tick];
  claim("the moment's line decided", at?.line === moment.line);
  claim("the moment's action", at?.action === moment.action);
  claim("the moment's readings", sameReadings(moment.readings, at?.readings));
  wrong.push(...falseReason(program, cause, ticks));
  const [fix] = fixes;
  if (fix === undefined) return wrong;
  const line = causeLine(diagnosis);
  claim(
    "the first fix changes the blamed line",
    line === null || !("line" in fix) || fix.line === line,
  );
  const changed = applyFix(program, fix);
  const isBump = event.kind === "bump";
  const until = isBump ? event.tick + 60 : goalBy;
  const after = switchedRun(maze, [program, changed], moment.tick, until);
  const isReached = after.goal !== null && after.goal <= goalBy;
  claim(
    "the fix removes the failure",
    isBump
      ? !after.bumps.includes(event.tick)
      : isReached || isFurther(cause, ticks, after.squares),
  );
  return wrong;
}

/**
 * A missing delay and a turn to a wall are also named if another mistake remains, but the robot gets to
 * new squares.
 */
function isFurther(
  cause: Cause,
  ticks: readonly PlainTick[],
  squares: ReadonlySet<string>,
): boolean {
  const isMissingDelay = cause.kind === "not-delayed" && cause.isAtEdge;
  const isIntoWall = cause.kind === "action" && cause.detail?.kind === "into-wall";
  if (!isMissingDelay && !isIntoWall) return false;
  const before = new Set(ticks.map(squareOf));
  return [...squares].filter((square) => !before.has(square)).length >= 2;
}

/** Otherwise the robot touched a corner beside the beam. */
function hadLess({
  needs,
  reading,
  contact,
}: Extract<Diagnosis["event"], { kind: "bump" }>): boolean {
  return needs === null || contact.isCorner || reading < needs + 0.001;
}

function falseReason(
  program: ProgramDocument,
  cause: Cause,
  ticks: readonly PlainTick[],
): string[] {
  const { moment } = cause;
  const { readings } = moment;
  const isTrue = (line: number): boolean =>
    evaluateCondition(program.rules[line]?.when ?? null, readings)?.isTrue === true;
  const holds = ((): boolean => {
    switch (cause.kind) {
      case "not-delayed":
        return (
          moment.action === `${cause.side} 90` && (!cause.isAtEdge || readings[cause.side] >= 125)
        );
      case "delayed":
        return moment.action === `delayed ${cause.side} 90` && cause.needs === 75;
      case "order":
        return isTrue(cause.line) && typeof moment.line === "number" && moment.line < cause.line;
      case "too-early":
      case "too-long":
        return (
          moment.line === cause.line &&
          droveOn(cause, ticks) === (cause.kind === "too-long") &&
          extremeHolds(cause, ticks)
        );
      case "too-late":
      case "too-short":
        return (
          !isTrue(cause.line) &&
          droveOn(cause, ticks) === (cause.kind === "too-short") &&
          extremeHolds(cause, ticks)
        );
      case "comparison":
        // The diagnosis states that it decided, or that it was not true.
        return moment.line === cause.line || !isTrue(cause.line);
      case "sensor":
        return cause.when.sensor === program.rules[cause.line]?.when?.sensor;
      case "action": {
        const { detail } = cause;
        if (detail?.kind === "no-room") return readings.front < detail.needs;
        if (detail?.kind === "into-wall") {
          return readings[detail.side] < 75 && readings[detail.open] >= 125;
        }
        if (detail?.kind !== "undoing") return true;
        return moment.action === "reverse" && actionIn(program, detail.other) === "forward";
      }
      case "missing":
        if (cause.isWall) return readings[cause.sensor] < 50;
        if (cause.sensor === "front") return readings.front > 50 && noneDrivesOn(program, cause);
        return (
          cause.hasTurn ||
          (cause.sensor !== "left" && cause.sensor !== "right") ||
          !ticks.some(({ action }) => action?.endsWith(`${cause.sensor} 90`))
        );
      case "extra":
        return moment.line === cause.line;
    }
  })();
  return holds ? [] : [cause.kind];
}

/** Whether no line above the one that decided drives forward at the moment. */
function noneDrivesOn({ rules }: ProgramDocument, { moment }: Cause): boolean {
  const above = moment.line === "default" ? rules : rules.slice(0, moment.line);
  return above.every(
    ({ when, do: action }) =>
      action !== "forward" || evaluateCondition(when, moment.readings)?.isTrue !== true,
  );
}

/** Whether the line drove the robot up to the moment. */
function droveOn({ line, moment }: WrongNumber, ticks: readonly PlainTick[]): boolean {
  const before = ticks[moment.tick - 1];
  return before?.line === line && !/90|180/.test(before.action ?? "");
}

function extremeHolds(cause: WrongNumber, ticks: readonly PlainTick[]): boolean {
  if (cause.number !== numberOf(cause.when)) return false;
  const decided = ticks.flatMap(({ line }, tick) => (line === cause.line ? [tick] : []));
  if (cause.extreme === "never") return decided.length === 0;
  if (cause.extreme === "missed") return !becomesTrueOnTheWay(cause, ticks);
  if (cause.extreme !== "always" || cause.when.than === "right") return true;
  const { sensor, than } = cause.when;
  return ticks.every(({ readings }) => readings[sensor] > than);
}

/** Whether the robot drives on to the place where the condition of the line becomes true. */
function becomesTrueOnTheWay(
  { when, moment, number }: WrongNumber,
  ticks: readonly PlainTick[],
): boolean {
  const later = ticks.slice(moment.tick).find(({ line, readings }) => {
    return line !== null && evaluateCondition(when, readings)?.isTrue === true;
  });
  return later !== undefined && Math.abs(later.readings[when.sensor] - number) <= 5;
}
