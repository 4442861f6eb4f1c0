/**
 * Changes of one thing in a program that may remove a failure, in the order in which a teacher
 * would try them: first the lines that decided last, and the most common mistakes of students.
 */
import {
  MAX_RULES,
  evaluateCondition,
  kindOf,
  numberOf,
  numberRange,
  type Condition,
  type ProgramDocument,
  type Rule,
} from "@corridor/program";
import { sensorNames, type LineRef, type PlainAction, type SensorName } from "@corridor/protocol";
import type { Fix } from "../advice.ts";
import type { BumpEvent, Decision, FailureEvent } from "./diagnosis.ts";
import type { RunTrace } from "./run-trace.ts";

/** A robot that turned too early may turn again at once, because its side is still open. */
const RECENT_TURNS = 3;
/**
 * The paper's numbers for an opening at a side, in addition to multiples of half a cell, in units. At
 * other distances to a wall ahead, the robot is not in the middle of a square.
 */
const SIDE_NUMBERS = [60, 75];
const NUMBER_STEP = 50;
const MAX_NUMBERS = 40;
/** Of a run that reached no goal, so many numbers of each line are tried before other changes. */
const NEAREST_NUMBERS = 10;
/** Numbers for comparisons of left and right, in units. */
const DIFFERENCES = [1, 0, 10, 50, 100, -1, -10, -50, -100];
const WALL_NEAR = 50;
const SIDE_OPEN = 60;
/** Conditions with numbers this close concern the same place. */
const SIMILAR = 25;

export const delayedTurn: Partial<Record<PlainAction, PlainAction>> = {
  "left 90": "delayed left 90",
  "right 90": "delayed right 90",
};
export const turnOnTheSpot: Partial<Record<PlainAction, PlainAction>> = {
  "delayed left 90": "left 90",
  "delayed right 90": "right 90",
};
const mirrored: Partial<Record<PlainAction, PlainAction>> = {
  "left 90": "right 90",
  "right 90": "left 90",
  "delayed left 90": "delayed right 90",
  "delayed right 90": "delayed left 90",
};
const plainTurns: readonly PlainAction[] = ["left 90", "right 90", "turn 180"];
const delayedTurns: readonly PlainAction[] = ["delayed left 90", "delayed right 90"];

/** All changes to try, the most likely first; may contain duplicates. */
export function* candidates(trace: RunTrace, event: FailureEvent): Generator<Fix> {
  if (event.kind === "bump") yield* forBump(trace, event);
  else yield* forNoGoal(trace);
}

function* forBump(trace: RunTrace, event: BumpEvent): Generator<Fix> {
  const { program } = trace;
  const { line, phase } = event;
  const lines = trace.decidingLines();
  if (line !== null && (phase === "delay" || phase === "way-out")) {
    const swap = swapped(program, line, turnOnTheSpot);
    const own = [...numbers(trace, line)];
    if (phase === "delay") yield* [...swap, ...own];
    else yield* [...own, ...swap];
  }
  const turns = recentTurns(trace);
  for (const turn of turns) yield* sooner(trace, turn);
  yield* orders(program, lines);
  if (line !== null && phase === "delay") yield* actions(program, line, plainTurns);
  for (const other of linesAbout(program, event.side)) {
    if (!lines.includes(other)) yield* numbers(trace, other);
  }
  for (const other of lines) yield* numbers(trace, other);
  for (const other of linesAbout(program, event.side)) yield* numbers(trace, other);
  yield* comparisons(program, lines);
  yield* comparisons(program, allLines(program));
  if (typeof line === "number") yield* actions(program, line, [...plainTurns, ...delayedTurns]);
  if (event.action === "reverse" && line !== null) yield* actions(program, line, ["forward"]);
  for (const turn of turns) yield* actions(program, turn, [...plainTurns, ...delayedTurns]);
  for (const other of numbered(lines)) {
    yield* actions(program, other, [...plainTurns, ...delayedTurns, "forward"]);
  }
  for (const other of numbered(allLines(program))) {
    yield* numbers(trace, other);
    yield* actions(program, other, [...plainTurns, ...delayedTurns, "forward"]);
  }
  yield* sensors(program);
  yield* newLines(trace, event.side);
  if (lines.includes("default")) yield* actions(program, "default", [...plainTurns, "forward"]);
  yield* forwardLines(program);
  yield* deletions(lines);
}

function* forNoGoal(trace: RunTrace): Generator<Fix> {
  const { program } = trace;
  const lines = trace.decidingLines();
  const turning = lines.filter((line) => isTurn(actionOf(program, line)));
  const backing = lines.filter((line) => actionOf(program, line) === "reverse");
  for (const line of backing) yield* actions(program, line, ["turn 180", "left 90", "right 90"]);
  for (const line of turning) yield* sooner(trace, line);
  yield* orders(program, lines);
  for (const line of lines) yield* numbers(trace, line, NEAREST_NUMBERS);
  for (const line of turning) yield* swapped(program, line, turnOnTheSpot);
  for (const line of turning) {
    const other = mirrored[actionOf(program, line)];
    if (other !== undefined) yield* actions(program, line, [other]);
  }
  for (const line of allLines(program)) {
    if (!lines.includes(line)) yield* numbers(trace, line, NEAREST_NUMBERS);
  }
  yield* comparisons(program, allLines(program));
  for (const line of numbered(allLines(program))) {
    yield* actions(program, line, [...plainTurns, ...delayedTurns, "forward"]);
  }
  yield* sensors(program);
  yield* actions(program, "default", [...plainTurns, "forward", ...delayedTurns]);
  yield* newLines(trace, "front");
  yield* forwardLines(program);
  yield* deletions(lines);
  for (const line of allLines(program)) yield* numbers(trace, line);
}

function allLines({ rules }: ProgramDocument): LineRef[] {
  return [...rules.keys()].filter((line) => rules[line]?.when !== null);
}

function numbered(lines: readonly LineRef[]): number[] {
  return lines.filter((line): line is number => typeof line === "number");
}

/** Lines of the latest turns, newest first. */
function recentTurns({ decisions }: RunTrace): LineRef[] {
  const turns = decisions.filter(({ action }) => isTurn(action)).slice(-RECENT_TURNS);
  return [...new Set(turns.map(({ line }) => line).toReversed())];
}

export function isTurn(action: PlainAction): boolean {
  return action.endsWith("90") || action === "turn 180";
}

/** Lines with a condition on this sensor. */
function linesAbout({ rules }: ProgramDocument, side: "front" | "back"): number[] {
  return [...rules.keys()].filter((line) => rules[line]?.when?.sensor === side);
}

export function actionOf({ rules, default: otherwise }: ProgramDocument, line: LineRef) {
  return line === "default" ? otherwise : (rules[line]?.do ?? otherwise);
}

/**
 * Changes of a turn that starts too early. At a wall ahead, the number is the usual mistake; at an
 * opening, it is the missing delay.
 */
function* sooner(trace: RunTrace, line: LineRef): Generator<Fix> {
  const delay = swapped(trace.program, line, delayedTurn);
  if (delay.length === 0) return;
  const turn = trace.decisions.findLast((each) => each.line === line);
  const front = turn === undefined ? null : lineOfWallAhead(trace, turn);
  if (front !== null) yield* numbers(trace, front);
  yield* delay;
}

/**
 * The line whose condition on the front sensor started the turn: its own one, or the one of the line
 * that drove the robot until then and is now false. null if the turn was not because of a wall ahead.
 */
export function lineOfWallAhead(
  trace: RunTrace,
  { tick, line, when, readings }: Decision,
): LineRef | null {
  if (when?.sensor === "front") return line;
  const before = trace.decisionBefore(tick);
  if (before?.when?.sensor !== "front") return null;
  return evaluateCondition(before.when, readings)?.isTrue === true ? null : before.line;
}

/** The same turn, delayed or on the spot. */
function swapped(
  program: ProgramDocument,
  line: LineRef,
  table: Partial<Record<PlainAction, PlainAction>>,
): Fix[] {
  const action = table[actionOf(program, line)];
  return action === undefined ? [] : [{ kind: "action", line, action }];
}

function actions(program: ProgramDocument, line: LineRef, menu: readonly PlainAction[]): Fix[] {
  const own = actionOf(program, line);
  return menu.flatMap((action): Fix[] =>
    action === own ? [] : [{ kind: "action", line, action }],
  );
}

/** Moves each line above a line that decided; the nearest position first. */
function orders({ rules }: ProgramDocument, lines: readonly LineRef[]): Fix[] {
  return numbered(lines).flatMap((to) =>
    [...rules.keys()]
      .filter((line) => line > to && rules[line]?.when !== null)
      .map((line): Fix => ({ kind: "move", line, to })),
  );
}

/** Other numbers of a line, nearest first. */
function* numbers({ program, maze }: RunTrace, line: LineRef, most = MAX_NUMBERS): Generator<Fix> {
  const when = typeof line === "number" ? program.rules[line]?.when : null;
  if (typeof line !== "number" || when === null || when === undefined) return;
  const own = numberOf(when);
  const longest = Math.max(maze.blocks.length, maze.blocks[0]?.length ?? 0) * 100;
  const steps = Array.from({ length: longest / NUMBER_STEP }, (_, at) => (at + 1) * NUMBER_STEP);
  const isSide = when.sensor === "left" || when.sensor === "right";
  const distances = isSide ? [...SIDE_NUMBERS, ...steps] : steps;
  const menu = when.than === "right" ? DIFFERENCES : distances;
  const { min, max } = numberRange(kindOf(when));
  const sorted = menu
    .filter((number) => number !== own && number >= min && number <= max)
    .toSorted((a, b) => Math.abs(a - own) - Math.abs(b - own))
    .slice(0, most);
  for (const number of sorted) yield { kind: "number", line, number };
}

/** The other comparison with the same number. */
function comparisons({ rules }: ProgramDocument, lines: readonly LineRef[]): Fix[] {
  return numbered(lines).flatMap((line): Fix[] => {
    const { when = null, do: action = "stop" } = rules[line] ?? {};
    // A turn to a side because there is room cannot have the wrong sign.
    if (when === null || (when.is === ">" && isTurnTo(action, when.sensor))) return [];
    return [{ kind: "condition", line, when: flipped(when) }];
  });
}

function flipped(when: Condition): Condition {
  return { ...when, is: when.is === ">" ? "<" : ">" };
}

/** Every other sensor for the conditions that compare one with a number. */
function sensors({ rules }: ProgramDocument): Fix[] {
  return rules.flatMap(({ when }, line) =>
    when === null || when.than === "right"
      ? []
      : sensorNames
          .filter((sensor) => sensor !== when.sensor)
          .map((sensor): Fix => ({ kind: "condition", line, when: { ...when, sensor } })),
  );
}

/**
 * New lines for a wall and for an opening on either side, at the end and at the top. A line that
 * has about the same condition is not missing: its number or action is wrong.
 */
function* newLines(trace: RunTrace, side: "front" | "back"): Generator<Fix> {
  for (const fix of linesToAdd(trace, side)) {
    const { when } = fix.rule;
    const isThere = trace.program.rules.some(
      (rule) => isSimilar(rule.when, when) || isForOpening(rule, when?.sensor),
    );
    if (!isThere) yield fix;
  }
}

/** Whether a line turns to a side with room. Its number is at most wrong. */
function isForOpening({ when, do: action }: Rule, side?: SensorName): boolean {
  return when?.sensor === side && when?.is === ">" && isTurnTo(action, when.sensor);
}

function isTurnTo(action: PlainAction, side: SensorName): boolean {
  return (side === "left" || side === "right") && action.endsWith(`${side} 90`);
}

function isSimilar(one: Condition | null, other: Condition | null): boolean {
  if (one === null || other === null || one.than === "right" || other.than === "right")
    return false;
  const isSame = one.sensor === other.sensor && one.is === other.is;
  return isSame && Math.abs(one.than - other.than) <= SIMILAR;
}

function* linesToAdd(
  { program, last }: RunTrace,
  side: "front" | "back",
): Generator<Extract<Fix, { kind: "insert" }>> {
  if (program.rules.length >= MAX_RULES) return;
  const [, right = 0, , left = 0] = last.readings;
  const turns: PlainAction[] =
    left > right ? ["left 90", "right 90", "turn 180"] : ["right 90", "left 90", "turn 180"];
  const ends = new Set([program.rules.length, 0]);
  for (const action of turns) {
    const rule: Rule = { when: { sensor: side, is: "<", than: WALL_NEAR }, do: action };
    for (const at of ends) yield { kind: "insert", at, rule };
  }
  for (const to of left > right ? (["left", "right"] as const) : (["right", "left"] as const)) {
    const rule: Rule = {
      when: { sensor: to, is: ">", than: SIDE_OPEN },
      do: `delayed ${to} 90`,
    };
    for (const at of ends) yield { kind: "insert", at, rule };
  }
}

/** New lines that drive forward if there is room ahead. */
function forwardLines({ rules }: ProgramDocument): Fix[] {
  if (rules.length >= MAX_RULES) return [];
  const rule: Rule = { when: { sensor: "front", is: ">", than: WALL_NEAR }, do: "forward" };
  return [...new Set([0, rules.length])].map((at): Fix => ({ kind: "insert", at, rule }));
}

function deletions(lines: readonly LineRef[]): Fix[] {
  return numbered(lines).map((line): Fix => ({ kind: "delete", line }));
}
