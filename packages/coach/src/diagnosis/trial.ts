/**
 * Simulates a changed program on a failed run, from its first different decision on: until then
 * both runs are the same.
 */
import { CELL } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import type { LineRef, Pose } from "@corridor/protocol";
import { ProgramRun } from "@corridor/simulation";
import { LoopDetector } from "../loop-detector.ts";
import type { RunTrace, SolvedCheck } from "./run-trace.ts";

/** Ticks after the failure during which a changed program must not bump. */
const PROVING_TICKS = 120;
/** Distance in units that the robot must get away from the failure. */
const PROVING_DISTANCE = 100;
/** New squares that count as progress; one alone may be a wider circle. */
const FURTHER_SQUARES = 2;

/** The criteria of success. */
export interface TrialTask {
  /** the last tick of a whole run */
  until: number;
  /** permitted bumps; null: any number, but a bump that is the failure must not recur */
  bumps: number | null;
  /** null if there is no task: then getting past the failure is the success */
  newSolvedCheck: (() => SolvedCheck) | null;
}

export interface TrialResult {
  /**
   * solved: the task is solved; lasts: the failure is removed, and no other one occurs within the
   * time; past: it is removed, and another one occurs; further: the goal is not reached either, but
   * the robot gets to new squares; fails: the failure recurs
   */
  outcome: "solved" | "lasts" | "past" | "further" | "fails";
  /** tick of the first different decision; null if there is none */
  from: number | null;
  /** number of simulated ticks */
  cost: number;
  /** lines that decided since the first different decision */
  lines: ReadonlySet<LineRef>;
  /** the longest distance in units from the middle of a square at which the robot turned */
  offCentre: number;
  /** whether a bump ended the trial */
  hasBumped: boolean;
}

/**
 * @param trace the failed run
 * @param program the changed program
 * @param from applies the change from the first different decision at or after this tick
 * @param isBump whether the failure is a bump; otherwise only a solved task removes it
 * @param renumbered the line whose number was changed: if it only decides later and then bumps at
 * once, the bump was postponed, not removed
 */
export function tryProgram(
  trace: RunTrace,
  program: ProgramDocument,
  task: TrialTask,
  isBump: boolean,
  from: number = trace.from,
  renumbered: LineRef | null = null,
): TrialResult {
  const compiled = new CompiledProgram(program);
  const start = trace.firstDifference(compiled, from);
  const lines = new Set<LineRef>();
  if (start === null)
    return { outcome: "fails", from: null, cost: 0, lines, offCentre: 0, hasBumped: false };
  const simulation = trace.at(start);
  const run = new ProgramRun(simulation, compiled);
  const solved = task.newSolvedCheck?.() ?? null;
  const detector = new LoopDetector(trace.maze);
  const result = (outcome: TrialResult["outcome"]): TrialResult => ({
    outcome,
    from: start,
    cost: simulation.tick - start,
    lines,
    offCentre,
    hasBumped: simulation.bumps > allowed,
  });
  const fresh = new Set<number>();
  const failed = () => result(fresh.size >= FURTHER_SQUARES && !isBump ? "further" : "fails");
  const without = isBump ? simulation.bumps : Infinity;
  const allowed = task.bumps === null ? without : Math.max(task.bumps, simulation.bumps);
  const provedAt = trace.until + PROVING_TICKS;
  const last = Math.max(task.until, provedAt);
  let failedAt = simulation.pose;
  let hasLeft = false;
  let isPast = false;
  let decidedAt: number | null = null;
  let offCentre = 0;
  while (simulation.tick < last) {
    if (simulation.tick === trace.until) failedAt = simulation.pose;
    const { heading } = simulation.pose;
    run.step();
    if (simulation.pose.heading !== heading) {
      offCentre = Math.max(offCentre, distanceFromMiddle(simulation.pose));
    }
    lines.add(run.line);
    if (run.line === renumbered) decidedAt ??= simulation.tick;
    if (simulation.bumps > allowed) {
      const isPostponed = decidedAt !== null && simulation.tick - decidedAt < PROVING_TICKS;
      return isPast && !isPostponed ? result("past") : failed();
    }
    if (solved?.(simulation) === true) {
      if (simulation.tick <= task.until) return result("solved");
      return isPast ? result("past") : failed();
    }
    if (isBump && !isPast && simulation.tick > trace.until) {
      const { x, y } = simulation.pose;
      const [dx, dy] = [x - failedAt.x, y - failedAt.y];
      hasLeft ||= dx * dx + dy * dy >= PROVING_DISTANCE * PROVING_DISTANCE;
      isPast = hasLeft && simulation.tick >= provedAt;
    }
    const { cell, isStopped, isManoeuvring, readings } = simulation;
    if (!trace.cells.has(cell)) fresh.add(cell);
    // The detector starts with this tick, independent of the failed run.
    const isWaiting = compiled.commandOf(compiled.decide(readings)).action === "stop";
    if (detector.update(cell, isStopped, isManoeuvring, run.line, isWaiting) !== null) {
      return isPast ? result("past") : failed();
    }
  }
  return isPast ? result("lasts") : failed();
}

/** Distance along the axis on which the robot is further from the middle of its square. */
export function distanceFromMiddle({ x, y }: Pose): number {
  return Math.max(offMiddle(x), offMiddle(y));
}

/** Distance sideways from the line through the middles of the squares along which the robot drives. */
export function distanceFromLane({ x, y, heading }: Pose): number {
  return Math.round(heading / 90) % 2 === 0 ? offMiddle(x) : offMiddle(y);
}

function offMiddle(at: number): number {
  return Math.abs((at % CELL) - CELL / 2);
}
