/**
 * Tries a changed program on a failed run: from the first decision that it takes differently, because
 * up to there the two runs are the same.
 */
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import { ProgramRun } from "@corridor/simulation";
import { LoopWatch } from "../loop-detector.ts";
import type { RunTrace, SolvedCheck } from "./run-trace.ts";

/** How long after the place of a failure a changed program must do without a bump, in ticks. */
const PROVING_TICKS = 120;
/** And how far away it must get by then or later: a robot that stands or dances is no better off. In units. */
const PROVING_DISTANCE = 100;
/** So many squares on which the failed run never was are further; one may be a wider circle. */
const FURTHER_SQUARES = 2;

/** What counts as success. */
export interface TrialTask {
  /** the last tick of a whole run */
  until: number;
  /** bumps that are allowed; null: any number, but a failure that is a bump may not come again */
  bumps: number | null;
  /** null where nothing is to be solved: then to get past the failure is all there is */
  newSolvedCheck: (() => SolvedCheck) | null;
}

export interface TrialResult {
  /**
   * solved: the task is done; lasts: this failure is gone, and no other one comes in the time of the task; past: it is
   * gone, and another one comes; further: the goal is not reached either, but the robot gets to squares on which the
   * failed run never was; fails: it is not gone
   */
  outcome: "solved" | "lasts" | "past" | "further" | "fails";
  /** the first tick on which the changed program decides differently; null where it never does */
  from: number | null;
  /** ticks that were simulated */
  cost: number;
  /** lines that decided since the first different decision */
  lines: ReadonlySet<LineRef>;
}

/**
 * @param trace the failed run
 * @param program the changed program
 * @param from the change counts from the first different decision at or after this tick
 * @param isBump whether the failure is a bump; otherwise only a solved task removes it
 * @param renumbered the line whose number was changed: where it only decides later and then bumps at once, the bump
 *   has been put off, not removed
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
  if (start === null) return { outcome: "fails", from: null, cost: 0, lines };
  const simulation = trace.at(start);
  const run = new ProgramRun(simulation, compiled);
  const solved = task.newSolvedCheck?.() ?? null;
  const watch = new LoopWatch(trace.maze);
  const result = (outcome: TrialResult["outcome"]): TrialResult => ({
    outcome,
    from: start,
    cost: simulation.tick - start,
    lines,
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
  while (simulation.tick < last) {
    if (simulation.tick === trace.until) failedAt = simulation.pose;
    run.step();
    lines.add(run.line);
    if (run.line === renumbered) decidedAt ??= simulation.tick;
    if (simulation.bumps > allowed) {
      const isPutOff = decidedAt !== null && simulation.tick - decidedAt < PROVING_TICKS;
      return isPast && !isPutOff ? result("past") : failed();
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
    // It begins with this tick: what the failed run did before does not count against the change.
    const isWaiting = compiled.commandOf(compiled.decide(readings)).action === "stop";
    if (watch.look(cell, isStopped, isManoeuvring, run.line, isWaiting) !== null) {
      return isPast ? result("past") : failed();
    }
  }
  return isPast ? result("lasts") : failed();
}
