/**
 * Replays a stretch of a run that only a program drove, from a saved state. Records every decision
 * with its readings, the cause of a bump, and the robot's state at any tick.
 */
import type { MazeDocument } from "@corridor/maze";
import { CompiledProgram, type Condition, type ProgramDocument } from "@corridor/program";
import type { LineRef, PlainAction, SensorReadings } from "@corridor/protocol";
import {
  Approach,
  ProgramRun,
  Simulation,
  type BumpCause,
  type SimulationState,
} from "@corridor/simulation";
import { LoopDetector } from "../loop-detector.ts";
import type { Decision, StuckEvent } from "./diagnosis.ts";

/** Interval of saved states, from which any tick can be simulated quickly. */
const STATE_TICKS = 120;
/** Instead of a rule: no decision, because a manoeuvre ran. */
const NO_DECISION = -2;

export interface TraceStart {
  maze: MazeDocument;
  program: ProgramDocument;
  /** the robot at the beginning of the stretch: at the start, or at a tick of a decision */
  state: SimulationState;
}

/** Checks after each tick whether the task is solved. Stateful: one per run. */
export type SolvedCheck = (robot: Simulation) => boolean;

export interface TraceLimits {
  /** the last tick */
  until: number;
  /** the stretch ends after more bumps than this; null: bumps do not end it */
  bumps: number | null;
  /** null if there is no task */
  isSolved: SolvedCheck | null;
}

export type TraceEnd = "bump" | "solved" | "late";

export class RunTrace {
  readonly maze: MazeDocument;
  readonly program: ProgramDocument;
  readonly from: number;
  readonly until: number;
  readonly end: TraceEnd;
  /** the cause of the bump that ended the stretch; null if none did */
  readonly bump: BumpCause | null;
  /** the robot at the last tick */
  readonly last: Simulation;
  /** decisions that differ from the previous one, and every turn, in order */
  readonly decisions: readonly Decision[];
  /** the first sign that the robot makes no progress; null if there was none */
  readonly notice: StuckEvent | null;
  /** visited squares */
  readonly cells: ReadonlySet<number>;
  readonly #states: SimulationState[] = [];
  /** front, right, back, left at the beginning of each tick */
  readonly #readings: Float64Array;
  /** the deciding rule of each tick; -1 for the default, -2 during a manoeuvre */
  readonly #rules: Int16Array;
  readonly #compiled: CompiledProgram;

  constructor({ maze, program, state }: TraceStart, { until, bumps, isSolved }: TraceLimits) {
    this.maze = maze;
    this.program = program;
    this.from = state.tick;
    this.#compiled = new CompiledProgram(program);
    const simulation = new Simulation(maze);
    simulation.restore(state);
    const run = new ProgramRun(simulation, this.#compiled);
    run.reconsider();
    const detector = new LoopDetector(maze);
    const approach = new Approach();
    const most = Math.max(0, until - this.from);
    const readings = new Float64Array(most * 4);
    const rules = new Int16Array(most);
    const decisions: Decision[] = [];
    const cells = new Set([simulation.cell]);
    let notice: RunTrace["notice"] = null;
    let bump: BumpCause | null = null;
    let end: TraceEnd = "late";
    for (let at = 0; at < most; at++) {
      if (at % STATE_TICKS === 0) this.#states.push(simulation.save());
      readings.set(simulation.readings, at * 4);
      const before = simulation.bumps;
      const command = run.decide();
      const { line } = run;
      rules[at] = command === null ? NO_DECISION : line === "default" ? -1 : line;
      if (command !== null) {
        approach.recordDecision(simulation, command);
        const { action } = this.#compiled.commandOf(line === "default" ? -1 : line);
        const last = decisions.at(-1);
        if (last?.line !== line || simulation.isManoeuvring) {
          const { tick, readings: now } = simulation;
          const when = conditionOf(program, line);
          decisions.push({ tick, line, when, action, readings: namedReadings(now) });
        }
      }
      run.step();
      const action = decisions.at(-1)?.action;
      const { cell, isStopped, isManoeuvring, tick } = simulation;
      cells.add(cell);
      const found = detector.update(cell, isStopped, isManoeuvring, line, action === "stop");
      if (found !== null) notice ??= { ...found, tick };
      if (simulation.bumps > before) bump = approach.cause(simulation);
      approach.update(simulation);
      if (bumps !== null && simulation.bumps > bumps) {
        end = "bump";
        break;
      }
      if (isSolved?.(simulation) === true) {
        end = "solved";
        break;
      }
    }
    this.#readings = readings;
    this.#rules = rules;
    this.end = end;
    this.bump = end === "bump" ? bump : null;
    this.notice = notice;
    this.cells = cells;
    this.decisions = decisions;
    this.last = simulation;
    this.until = simulation.tick;
  }

  /** The robot at the beginning of a tick of the stretch, before its decision. */
  at(tick: number): Simulation {
    const index = Math.floor((tick - this.from) / STATE_TICKS);
    const state = this.#states[index];
    if (state === undefined) throw new RangeError(`Tick ${tick} is not in the trace.`);
    const simulation = new Simulation(this.maze);
    simulation.restore(state);
    const run = new ProgramRun(simulation, this.#compiled);
    run.reconsider();
    while (simulation.tick < tick) run.step();
    return simulation;
  }

  /** The robot at the first tick from `tick` on with a decision. */
  stateFrom(tick: number): SimulationState {
    let from = Math.max(this.from, tick);
    while (this.decisionAt(from) === null && from < this.until - 1) from++;
    return this.at(from).save();
  }

  /** The readings at the beginning of a tick. */
  readingsAt(tick: number): SensorReadings {
    const at = (tick - this.from) * 4;
    return namedReadings(this.#readings.subarray(at, at + 4));
  }

  /** The decision of a tick; null during a manoeuvre. */
  decisionAt(tick: number): Decision | null {
    const rule = this.#rules[tick - this.from] ?? NO_DECISION;
    if (rule === NO_DECISION) return null;
    const { action } = this.#compiled.commandOf(rule);
    const line = rule < 0 ? "default" : rule;
    const when = conditionOf(this.program, line);
    return { tick, line, when, action, readings: this.readingsAt(tick) };
  }

  /**
   * The decision of the previous tick for an endless motion; null after a manoeuvre and at the
   * start.
   */
  decisionBefore(tick: number): Decision | null {
    const before = tick > this.from ? this.decisionAt(tick - 1) : null;
    return before !== null && isSteady(before.action) ? before : null;
  }

  /** The first tick from `from` on at which another program chooses another action; null: none. */
  firstDifference(other: CompiledProgram, from: number = this.from): number | null {
    const readings = new Float64Array(4);
    for (let tick = from; tick < this.until; tick++) {
      const at = tick - this.from;
      const rule = this.#rules[at] ?? NO_DECISION;
      if (rule === NO_DECISION) continue;
      readings.set(this.#readings.subarray(at * 4, at * 4 + 4));
      const { action } = other.commandOf(other.decide(readings));
      if (action !== this.#compiled.commandOf(rule).action) return tick;
    }
    return null;
  }

  /** The ticks at which another program begins to choose other actions, in order. */
  differences(other: CompiledProgram): number[] {
    const ticks: number[] = [];
    let last = -1;
    let next = this.firstDifference(other);
    while (next !== null) {
      if (next - 1 !== last) ticks.push(next);
      last = next;
      next = this.firstDifference(other, next + 1);
    }
    return ticks;
  }

  /** Whether a condition is true at any decision. */
  isEverTrue(when: Condition): boolean {
    return this.firstTrue(when) !== null;
  }

  /** The tick of the first decision from `from` on at which a condition is true; null: never. */
  firstTrue(when: Condition, from: number = this.from): number | null {
    const asked = new CompiledProgram({ ...this.program, rules: [{ when, do: "stop" }] });
    const readings = new Float64Array(4);
    for (let at = from - this.from; at < this.until - this.from; at++) {
      if (this.#rules[at] === NO_DECISION) continue;
      readings.set(this.#readings.subarray(at * 4, at * 4 + 4));
      if (asked.decide(readings) === 0) return this.from + at;
    }
    return null;
  }

  /** The lines that decided, newest first. */
  decidingLines(): LineRef[] {
    return [...new Set(this.decisions.map(({ line }) => line).toReversed())];
  }
}

function conditionOf({ rules }: ProgramDocument, line: LineRef): Condition | null {
  return line === "default" ? null : (rules[line]?.when ?? null);
}

function namedReadings(readings: Float64Array): SensorReadings {
  const [front = 0, right = 0, back = 0, left = 0] = readings;
  return { front, right, back, left };
}

/** Whether the action lasts until the next decision. */
function isSteady(action: PlainAction): boolean {
  return action === "forward" || action === "reverse" || action === "stop";
}
