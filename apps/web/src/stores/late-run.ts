/**
 * The run for what is displayed one frame later than the marks and numbers: the timeline, and the words for a
 * screen reader. Every number of the run comes from the run store itself, so that all of them belong to one tick.
 * On a slow computer all together take longer than a frame.
 */
import { createRunStore, type RunState, type RunStore } from "./run-store.ts";

export class LateRun {
  /** for words without numbers, and whatever else is not urgent */
  readonly words: RunStore = createRunStore();
  readonly #later: (work: () => void) => void;
  /** null while nothing waits */
  #waiting: (() => void)[] | null = null;

  /**
   * @param later does something one frame later. By a timer: a frame that is asked for costs, though nothing
   *   changed in it, and most news change no mark
   */
  constructor(run: RunStore, later: (work: () => void) => void) {
    this.#later = later;
    run.subscribe((state, before) => {
      this.#catchUp();
      const words = () => this.words.setState(state, true);
      if (isGoingOn(before, state)) this.#wait(words);
      else words();
    });
  }

  /** Does what belongs to the newest state: where its words wait, with them. */
  after(work: () => void): void {
    if (this.#waiting === null) work();
    else this.#waiting.push(work);
  }

  #wait(work: () => void): void {
    const waiting = [work];
    this.#waiting = waiting;
    this.#later(() => {
      if (this.#waiting === waiting) this.#catchUp();
    });
  }

  /** Does what waits; newer news are told after it. */
  #catchUp(): void {
    const waiting = this.#waiting ?? [];
    this.#waiting = null;
    for (const work of waiting) work();
  }
}

function isGoingOn(before: RunState, { snapshot }: RunState): boolean {
  return snapshot?.state === "running" && before.snapshot?.state === "running";
}
