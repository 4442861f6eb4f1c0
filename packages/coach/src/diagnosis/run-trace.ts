/**
 * One stretch of a run that a program alone drove, driven once more from the same state: every
 * decision with its readings, how a bump came about, and the robot at any tick of it.
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
import { LoopWatch } from "../loop-detector.ts";
import type { DecisionMoment, StuckEvent } from "./diagnosis.ts";

/** A state is saved this often, so that any tick is a short drive from one. */
const STATE_TICKS = 120;
/** Beside the rules: no decision, because a manoeuvre ran. */
const NO_DECISION = -2;

export interface TraceStart {
  maze: MazeDocument;
  program: ProgramDocument;
  /** the robot where the stretch begins: at the start, or at a tick on which the program decides */
  state: SimulationState;
}

/** Says after each tick whether the task is solved; a new one for each run. */
export type SolvedCheck = (robot: Simulation) => boolean;

export interface TraceLimits {
  /** the last tick */
  until: number;
  /** more bumps than this end it; null: bumps do not end it */
  bumps: number | null;
  /** null where nothing is to be solved */
  isSolved: SolvedCheck | null;
}

export type TraceEnd = "bump" | "solved" | "late";

export class RunTrace {
  readonly maze: MazeDocument;
  readonly program: ProgramDocument;
  readonly from: number;
  readonly until: number;
  readonly end: TraceEnd;
  /** how it came to the bump that ended the stretch; null where none did */
  readonly bump: BumpCause | null;
  /** the robot at the last tick */
  readonly last: Simulation;
  /** decisions that differ from the one before, and every turn, in their order */
  readonly decisions: readonly DecisionMoment[];
  /** the first sign that the robot gets nowhere; null where there was none */
  readonly notice: StuckEvent | null;
  /** squares on which the robot was */
  readonly cells: ReadonlySet<number>;
  readonly #states: SimulationState[] = [];
  /** front, right, back, left at the beginning of each tick */
  readonly #readings: Float64Array;
  /** rule that decided for each tick, -1 for the default, -2 where a manoeuvre ran */
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
    const watch = new LoopWatch(maze);
    const approach = new Approach();
    const most = Math.max(0, until - this.from);
    const readings = new Float64Array(most * 4);
    const rules = new Int16Array(most);
    const decisions: DecisionMoment[] = [];
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
      const found = watch.look(cell, isStopped, isManoeuvring, line, action === "stop");
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

  /** The robot at the first tick from `tick` on for which the program decides. */
  stateFrom(tick: number): SimulationState {
    let from = Math.max(this.from, tick);
    while (this.decisionAt(from) === null && from < this.until - 1) from++;
    return this.at(from).save();
  }

  /** What the sensors read at the beginning of a tick. */
  readingsAt(tick: number): SensorReadings {
    const at = (tick - this.from) * 4;
    return namedReadings(this.#readings.subarray(at, at + 4));
  }

  /** The decision for a tick; null where a manoeuvre runs. */
  decisionAt(tick: number): DecisionMoment | null {
    const rule = this.#rules[tick - this.from] ?? NO_DECISION;
    if (rule === NO_DECISION) return null;
    const { action } = this.#compiled.commandOf(rule);
    const line = rule < 0 ? "default" : rule;
    const when = conditionOf(this.program, line);
    return { tick, line, when, action, readings: this.readingsAt(tick) };
  }

  /** The decision for the tick before, where the robot drives on; null where a manoeuvre ran, and at the start. */
  decisionBefore(tick: number): DecisionMoment | null {
    const before = tick > this.from ? this.decisionAt(tick - 1) : null;
    return before !== null && isSteady(before.action) ? before : null;
  }

  /** The first tick from `from` on for which another program chooses another action; null: none. */
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

  /** Whether a condition holds for the readings of any tick from `from` on for which the program decides. */
  isEverTrue(when: Condition, from: number = this.from): boolean {
    const asked = new CompiledProgram({ ...this.program, rules: [{ when, do: "stop" }] });
    const readings = new Float64Array(4);
    for (let at = from - this.from; at < this.until - this.from; at++) {
      if (this.#rules[at] === NO_DECISION) continue;
      readings.set(this.#readings.subarray(at * 4, at * 4 + 4));
      if (asked.decide(readings) === 0) return true;
    }
    return false;
  }

  /** Lines that decided, the newest decision first. */
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

/** Whether the action lasts until another one is chosen. */
function isSteady(action: PlainAction): boolean {
  return action === "forward" || action === "reverse" || action === "stop";
}
