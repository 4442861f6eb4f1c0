/**
 * A failed attempt driven once more, with all that can tell which line led it astray: its turns, the
 * lines that were true and not read, the openings that it passed.
 */
import type { MazeDocument } from "@corridor/maze";
import { CompiledProgram, truthOf, type ProgramDocument } from "@corridor/program";
import type { LineRef, PlainAction, SensorReadings } from "@corridor/protocol";
import { ProgramRun, Simulation } from "@corridor/simulation";
import type { Side } from "./advice.ts";
import { LoopWatch, type LoopNotice } from "./loop-watch.ts";
import { OPENING } from "./turn-findings.ts";

/** A moment at which a line decided. */
export interface DecisionMoment {
  tick: number;
  line: LineRef;
  action: PlainAction;
  readings: SensorReadings;
}

/** A line that was true while one above it decided something else. */
export interface UnreadLine {
  line: number;
  above: number;
  tick: number;
  readings: SensorReadings;
}

export interface AttemptTrace {
  /** how many ticks it took, up to the bump or to the end */
  ticks: number;
  hasBumped: boolean;
  /** decisions that began a turn, in their order */
  turns: DecisionMoment[];
  /** the newest decision of all */
  last: DecisionMoment | null;
  /** readings when it ended */
  readings: SensorReadings;
  /** the first moment for each line */
  unread: UnreadLine[];
  /** the first opening that was passed on each side */
  openings: Partial<Record<Side, DecisionMoment>>;
  /** how often one decision drove back and the next one forward, or the other way about */
  reversals: number;
  notice: LoopNotice | null;
}

const sides = ["left", "right"] as const;

/** @param ticks at most so many; it ends at the first bump where bumps matter */
export function traceAttempt(
  program: ProgramDocument,
  maze: MazeDocument,
  ticks: number,
  endsAtBump: boolean,
): AttemptTrace {
  const simulation = new Simulation(maze);
  const run = new ProgramRun(simulation, new CompiledProgram(program));
  const watch = new LoopWatch(maze);
  const unread = new Map<number, UnreadLine>();
  const trace: AttemptTrace = {
    ticks: 0,
    hasBumped: false,
    turns: [],
    last: null,
    readings: simulation.report().sensors,
    unread: [],
    openings: {},
    reversals: 0,
    notice: null,
  };
  while (simulation.tick < ticks && !(endsAtBump && simulation.bumps > 0)) {
    const isDecision = !simulation.isManoeuvring;
    const { tick } = simulation;
    const readings = isDecision ? simulation.report().sensors : null;
    run.step();
    const { line } = run;
    const action = actionOf(program, line);
    if (readings !== null) note({ tick, line, action, readings });
    const { cell, isStopped, isManoeuvring } = simulation;
    trace.notice ??= watch.look(cell, isStopped, isManoeuvring, line, action === "stop");
  }
  trace.ticks = simulation.tick;
  trace.hasBumped = simulation.bumps > 0;
  trace.readings = simulation.report().sensors;
  trace.unread = [...unread.values()];
  return trace;

  function note(moment: DecisionMoment): void {
    const { line, action, readings, tick } = moment;
    const before = trace.last?.action;
    if (
      (action === "forward" && before === "reverse") ||
      (action === "reverse" && before === "forward")
    ) {
      trace.reversals++;
    }
    trace.last = moment;
    if (action.endsWith("90")) trace.turns.push(moment);
    for (const side of sides) {
      if (readings[side] >= OPENING) trace.openings[side] ??= moment;
    }
    if (line === "default") return;
    for (let below = line + 1; below < program.rules.length; below++) {
      const rule = program.rules[below];
      if (rule === undefined || rule.do === action || unread.has(below)) continue;
      if (truthOf(rule.when, readings)?.isTrue !== true) continue;
      unread.set(below, { line: below, above: line, tick, readings });
    }
  }
}

export function actionOf({ rules, default: otherwise }: ProgramDocument, line: LineRef) {
  return line === "default" ? otherwise : (rules[line]?.do ?? otherwise);
}
