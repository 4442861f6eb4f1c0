/**
 * The run for what is shown later than what decides. Marks come at once: which line drives, what is true.
 * Numbers follow one frame later, and at a turn of the program words and timeline after them: on a slow
 * computer all together are longer than a frame, and the stage would stand still.
 */
import { createRunStore, type RunState, type RunStore } from "./run-store.ts";

/** What is done in one frame. */
type Works = (() => void)[];

export class LateRun {
  /** for numbers, wherever they stand */
  readonly numbers: RunStore = createRunStore();
  /** for the words below a line, and whatever else is no hurry */
  readonly words: RunStore = createRunStore();
  readonly #later: (work: () => void) => void;
  /** frame by frame */
  #waiting: Works[] = [];

  /**
   * @param later does something one frame later. By a timer: a frame that is asked for costs, though nothing
   *   changed in it, and most news change no mark
   */
  constructor(run: RunStore, later: (work: () => void) => void) {
    this.#later = later;
    run.subscribe((state, before) => {
      this.#catchUp();
      const numbers = () => this.numbers.setState(state, true);
      const words = () => this.words.setState(state, true);
      if (isTurn(before, state)) this.#wait([[numbers], [words]]);
      else if (isGoingOn(before, state)) this.#wait([[numbers, words]]);
      else for (const work of [numbers, words]) work();
    });
  }

  /** Does what belongs to the newest state: where its words wait, with them. */
  after(work: () => void): void {
    const last = this.#waiting.at(-1);
    if (last === undefined) work();
    else last.push(work);
  }

  /** @param frames what waits now: when other news come they do it, and wait for themselves */
  #wait(frames: Works[]): void {
    this.#waiting = frames;
    this.#later(() => {
      if (this.#waiting !== frames) return;
      for (const work of frames.shift() ?? []) work();
      if (frames.length > 0) this.#wait(frames);
    });
  }

  /** News are told in their order: what waits for older ones does not wait any longer. */
  #catchUp(): void {
    const waiting = this.#waiting;
    this.#waiting = [];
    for (const work of waiting.flat()) work();
  }
}

function isGoingOn(before: RunState, { snapshot }: RunState): boolean {
  return snapshot?.state === "running" && before.snapshot?.state === "running";
}

/** Whether another line drives, or a manoeuvre begins or ends, in a run that goes on. */
function isTurn(before: RunState, state: RunState): boolean {
  return (
    isGoingOn(before, state) &&
    (state.snapshot?.line !== before.snapshot?.line ||
      (state.progress === null) !== (before.progress === null))
  );
}
