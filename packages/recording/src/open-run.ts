/** From a run document to the recorded run, ended where the document ends. */
import type { ReadResult } from "@corridor/protocol";
import { Recording } from "./recording.ts";
import type { RunDocument } from "./run-document.ts";
import { MAX_RUN_TICKS } from "./run-limits.ts";

/** So many ticks are run between two looks at whether there is time for more. */
const TICKS_PER_CHECK = 64;

/**
 * A document that is run again, a stretch at a time: a few characters can ask for a day, which takes
 * half a minute, and whoever runs it has other things to do meanwhile.
 */
export class Replay {
  readonly #run: RunDocument;
  readonly #recording: Recording;
  /** how far it is run in all, in ticks */
  readonly ticks: number;
  /** index of the next input */
  #next = 0;
  #isChecked = false;

  /** @param until runs on to this tick without further inputs */
  constructor(run: RunDocument, until = run.ticks) {
    this.#run = run;
    this.#recording = new Recording(run.maze, run.program);
    this.ticks = Math.max(run.ticks, Math.min(until, MAX_RUN_TICKS));
  }

  /** The tick that was reached. */
  get tick(): number {
    return this.#recording.run.tick;
  }

  /**
   * Runs on, and checks that the document ends in the same bits.
   * @param hasTime asked now and then whether there is time for more
   * @returns null while it is not done; then the recording, or the problem where an input cannot be at
   * its tick or the digest is another
   */
  advance(hasTime: () => boolean): ReadResult<Recording> | null {
    const { inputs, ticks } = this.#run;
    const { run } = this.#recording;
    do {
      const input = inputs[this.#next];
      const target = input?.tick ?? (this.#isChecked ? this.ticks : ticks);
      for (let i = 0; i < TICKS_PER_CHECK && run.tick < target; i++) this.#recording.step();
      if (run.tick < target) continue;
      const end = input === undefined ? this.#finish() : this.#applyInput(input);
      if (end !== null) return end;
    } while (hasTime());
    return null;
  }

  #applyInput({ tick: _tick, ...input }: RunDocument["inputs"][number]): ReadResult<never> | null {
    if (this.#recording.addInput(input)) {
      this.#next++;
      return null;
    }
    const isMaze = input.do === "maze";
    return refuse(
      `inputs[${this.#next}]`,
      isMaze ? "a maze with a block where the robot stands" : `a ${input.do}`,
      isMaze ? "a maze with room for the robot" : "an input while a hand or a script drives",
    );
  }

  #finish(): ReadResult<Recording> | null {
    if (this.#isChecked) return { ok: true, value: this.#recording };
    const digest = this.#recording.run.digest();
    if (digest !== this.#run.digest) {
      return refuse("digest", this.#run.digest, `${digest}, which is what this run ends in here`);
    }
    this.#isChecked = true;
    return null;
  }
}

/**
 * Runs a document again in one go.
 * @param until runs on to this tick without further inputs
 */
export function openRun(run: RunDocument, until = run.ticks): ReadResult<Recording> {
  const replay = new Replay(run, until);
  for (;;) {
    const end = replay.advance(() => true);
    if (end !== null) return end;
  }
}

function refuse(path: string, found: string, expected: string): ReadResult<never> {
  return { ok: false, problems: [{ path, found, expected }] };
}
