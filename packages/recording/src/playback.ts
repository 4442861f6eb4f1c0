/** Plays a recording back on a separate run, and seeks to any tick. */
import type { Inputs } from "./inputs.ts";
import type { Keyframes } from "./keyframes.ts";
import { Run } from "./run.ts";

export class Playback {
  readonly #inputs: Inputs;
  readonly #keyframes: Keyframes;
  readonly #run: Run;
  /** index of the next input */
  #next = 0;

  constructor(inputs: Inputs, keyframes: Keyframes) {
    this.#inputs = inputs;
    this.#keyframes = keyframes;
    const { maze, program } = keyframes.before(0).state;
    this.#run = new Run(maze, program);
    this.#applyInputs();
  }

  /** The run at the current tick of the playback. Read only. */
  get run(): Run {
    return this.#run;
  }

  /** Seeks to the end of a tick of the recording, after all inputs at that tick. */
  seek(tick: number): void {
    const { state } = this.#keyframes.before(tick);
    const isAhead = tick >= this.#run.tick && this.#run.tick >= state.simulation.tick;
    if (!isAhead) {
      this.#run.restore(state);
      this.#next = this.#inputs.indexAt(this.#run.tick);
      this.#applyInputs();
    }
    while (this.#run.tick < tick) this.step();
  }

  /** Plays one tick. */
  step(): void {
    this.#run.step();
    this.#applyInputs();
  }

  #applyInputs(): void {
    const { tick } = this.#run;
    for (
      let input = this.#inputs.at(this.#next);
      input?.tick === tick;
      input = this.#inputs.at(++this.#next)
    ) {
      this.#run.apply(input);
    }
  }
}
