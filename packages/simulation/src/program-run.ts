/**
 * A program that drives a robot. On every tick without a running manoeuvre, a line decides.
 *
 * `decide` can run before the tick, so that the page can display the line chosen by the current
 * readings. `step` counts the decision.
 */
import type { Command, LineRef } from "@corridor/protocol";
import type { Simulation } from "./simulation.ts";

/** The interface of a compiled program that a run requires. */
export interface Decider {
  /** number of rules, including rules without effect */
  readonly ruleCount: number;
  /**
   * Returns the index of the rule for these readings (front, right, back, left), or -1 for the
   * default.
   */
  decide(readings: Float64Array): number;
  /** Returns the command of a rule, or of the default for -1. Always returns the same object. */
  commandOf(rule: number): Command;
}

/** The state of a program run, without the robot. */
export interface ProgramRunState {
  rule: number;
  isDecided: boolean;
  decisions: Float64Array;
}

export class ProgramRun {
  readonly #simulation: Simulation;
  #decider: Decider;
  #rule = -1;
  #isDecided = false;
  /** number of decisions: of the default at index 0, of the rules from index 1 on */
  #decisions: Float64Array;

  constructor(simulation: Simulation, decider: Decider) {
    this.#simulation = simulation;
    this.#decider = decider;
    this.#decisions = new Float64Array(decider.ruleCount + 1);
  }

  /** Number of decisions since the last program change: the default at index 0, then the rules. */
  get decisions(): Readonly<Float64Array> {
    return this.#decisions;
  }

  /** The line that decides now or that started the running manoeuvre. */
  get line(): LineRef {
    return this.#rule < 0 ? "default" : this.#rule;
  }

  save(): ProgramRunState {
    return { rule: this.#rule, isDecided: this.#isDecided, decisions: this.#decisions.slice() };
  }

  /**
   * Restores a saved state. The caller restores the simulation.
   * @param decider the program at the time of `save`
   */
  restore(state: ProgramRunState, decider: Decider = this.#decider): void {
    this.#decider = decider;
    this.#rule = state.rule;
    this.#isDecided = state.isDecided;
    this.#decisions = state.decisions.slice();
  }

  /**
   * Decides for the next tick, unless a decision exists or a manoeuvre runs.
   * @returns the new command, or null
   */
  decide(): Command | null {
    const simulation = this.#simulation;
    if (this.#isDecided || simulation.isManoeuvring) return null;
    this.#rule = this.#decider.decide(simulation.readings);
    this.#isDecided = true;
    const command = this.#decider.commandOf(this.#rule);
    simulation.apply(command);
    return command;
  }

  /** Discards a decision whose tick has not run, because the readings or the rules changed. */
  reconsider(decider: Decider = this.#decider): void {
    if (decider !== this.#decider) this.#decisions = new Float64Array(decider.ruleCount + 1);
    this.#decider = decider;
    if (this.#isDecided) this.#simulation.apply({ action: "stop" });
    this.#isDecided = false;
  }

  /** Runs one tick. */
  step(): void {
    this.decide();
    if (this.#isDecided) {
      const at = this.#rule + 1;
      this.#decisions[at] = (this.#decisions[at] ?? 0) + 1;
      this.#isDecided = false;
    }
    this.#simulation.step();
  }
}
