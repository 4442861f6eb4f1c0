/** Replays a run document to a recording. */
import type { ReadResult } from "@corridor/protocol";
import { Recording } from "./recording.ts";
import type { RunDocument } from "./run-document.ts";
import { MAX_RUN_TICKS } from "./run-limits.ts";

/** Number of ticks between two calls of `hasTime`. */
const TICKS_PER_CHECK = 64;

/**
 * Replays a document in steps. A short document can contain a run of a day, which takes half a
 * minute to replay. Steps let the caller do other work in between.
 */
export class Replay {
  readonly #run: RunDocument;
  readonly #recording: Recording;
  /** total number of ticks to run */
  readonly ticks: number;
  /** index of the next input */
  #next = 0;
  #isChecked = false;

  /** @param until continues to this tick without further inputs */
  constructor(run: RunDocument, until = run.ticks) {
    this.#run = run;
    this.#recording = new Recording(run.maze, run.program);
    this.ticks = Math.max(run.ticks, Math.min(until, MAX_RUN_TICKS));
  }

  /** The current tick. */
  get tick(): number {
    return this.#recording.run.tick;
  }

  /**
   * Continues the replay, and checks the digest at the end of the document.
   * @param hasTime called every `TICKS_PER_CHECK` ticks; the replay pauses if it returns false
   * @returns null while the replay is not complete; then the recording, or the problem if an input
   *   is not possible at its tick or the digest differs
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
      isMaze ? "a maze with a block at the robot's position" : `a ${input.do}`,
      isMaze ? "a maze with an open robot position" : "an input while the user or a script drives",
    );
  }

  #finish(): ReadResult<Recording> | null {
    if (this.#isChecked) return { ok: true, value: this.#recording };
    const digest = this.#recording.run.digest();
    if (digest !== this.#run.digest) {
      return refuse("digest", this.#run.digest, `${digest}, the digest of the replayed run`);
    }
    this.#isChecked = true;
    return null;
  }
}

/**
 * Replays a document in one call.
 * @param until continues to this tick without further inputs
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
