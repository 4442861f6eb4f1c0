/** Formats the results of runs as JSON or CSV. Rounds distances to 0.1 and poses to 0.001. */
import type { Diagnosis } from "@corridor/coach";
import { csvLines } from "@corridor/report";
import { TICKS_PER_SECOND } from "@corridor/protocol";
import { round } from "./round.ts";
import type { RunResult } from "./run-result.ts";

/** A run's result with the paths of its program and maze. */
export interface GradedRun {
  program: string;
  maze: string;
  result: RunResult;
  diagnosis: Diagnosis | null;
}

/** Formats a result as one line of JSON. The fields of `names` come first, those of `more` last. */
export function jsonLine(
  result: RunResult,
  names: Record<string, string> = {},
  more: { diagnosis?: Diagnosis | null } = {},
): string {
  const { ticks, bumps, visitedCells, openCells, distance, goalTick, pose } = result;
  const head = JSON.stringify({
    ...names,
    ticks,
    seconds: round(ticks / TICKS_PER_SECOND, 3),
    bumps,
    visitedCells,
    openCells,
    distance: round(distance, 1),
    goal: { reached: goalTick !== null, tick: goalTick },
    pose: { x: round(pose.x, 3), y: round(pose.y, 3), heading: round(pose.heading, 3) },
  });
  // Concatenated because an object would order the integer keys "0" and "1" before "default".
  const { decisions } = result;
  const rules = decisions.rules.map((count, rule) => `,"${rule}":${count}`).join("");
  const tail = more.diagnosis === undefined ? "" : `,"diagnosis":${JSON.stringify(more.diagnosis)}`;
  return `${head.slice(0, -1)},"lines":{"default":${decisions.default}${rules}}${tail}}`;
}

/** The last line of the output of `grade`. */
export function summaryLine(runs: readonly GradedRun[]): string {
  const count = (matches: (result: RunResult) => boolean): number =>
    runs.filter(({ result }) => matches(result)).length;
  return JSON.stringify({
    summary: {
      runs: runs.length,
      goalReached: count(({ goalTick }) => goalTick !== null),
      withoutBumps: count(({ bumps }) => bumps === 0),
      allCellsVisited: count(({ visitedCells, openCells }) => visitedCells === openCells),
    },
  });
}

const csvColumns = [
  "program",
  "maze",
  "ticks",
  "seconds",
  "bumps",
  "visitedCells",
  "openCells",
  "distance",
  "goalReached",
  "goalTick",
] as const;

/** Formats runs as a CSV table. @returns its lines */
export function runTable(runs: readonly GradedRun[]): string[] {
  const rows = runs.map(({ program, maze, result }) => [
    program,
    maze,
    result.ticks,
    round(result.ticks / TICKS_PER_SECOND, 3),
    result.bumps,
    result.visitedCells,
    result.openCells,
    round(result.distance, 1),
    result.goalTick !== null,
    result.goalTick ?? "",
  ]);
  return csvLines(csvColumns, rows);
}
