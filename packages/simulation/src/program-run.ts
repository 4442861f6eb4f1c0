/**
 * A program driving a robot: on every tick on which no manoeuvre runs, a line decides.
 *
 * The decision for the next tick can be taken early, so that what is shown at the end of a tick is
 * the line that these very readings chose; it counts when its tick runs.
 */
import type { Command, LineRef } from "@corridor/protocol";
import type { Simulation } from "./simulation.ts";

/** The part of a compiled program that a run needs. */
export interface Decider {
  /** rules of the program, those that do nothing included */
  readonly ruleCount: number;
  /** index of the rule that decides for these readings (front, right, back, left), or -1 for the default */
  decide(readings: Float64Array): number;
  /** the command of a rule, or of the default at -1; the same object each time */
  commandOf(rule: number): Command;
}

/** What a program run knows beside the robot. */
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
  /** how often each has decided: the default at 0, the rules from 1 on */
  #decisions: Float64Array;

  constructor(simulation: Simulation, decider: Decider) {
    this.#simulation = simulation;
    this.#decider = decider;
    this.#decisions = new Float64Array(decider.ruleCount + 1);
  }

  /** How often each has decided since the last change of the program: the default at 0, then the rules. */
  get decisions(): Readonly<Float64Array> {
    return this.#decisions;
  }

  /** The line that decides now or began the manoeuvre that runs. */
  get line(): LineRef {
    return this.#rule < 0 ? "default" : this.#rule;
  }

  save(): ProgramRunState {
    return { rule: this.#rule, isDecided: this.#isDecided, decisions: this.#decisions.slice() };
  }

  /** Goes on where it was saved; the robot is restored beside it. `decider`: the program of that moment. */
  restore(state: ProgramRunState, decider: Decider = this.#decider): void {
    this.#decider = decider;
    this.#rule = state.rule;
    this.#isDecided = state.isDecided;
    this.#decisions = state.decisions.slice();
  }

  /**
   * Takes the decision for the next tick, unless it is taken or a manoeuvre runs.
   * @returns the command that was decided now; null when nothing was to be decided
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

  /** Drops a decision whose tick has not run: the readings or the rules have changed. */
  reconsider(decider: Decider = this.#decider): void {
    if (decider !== this.#decider) this.#decisions = new Float64Array(decider.ruleCount + 1);
    this.#decider = decider;
    if (this.#isDecided) this.#simulation.apply({ action: "stop" });
    this.#isDecided = false;
  }

  /** One tick. */
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
