/**
 * The run for what moves other parts of the page: the words below the line that drives, the timeline. Of a
 * turn of the program they hear after the numbers, each in a frame of its own: on a slow computer all
 * together are longer than a frame, and the stage would stand still.
 */
import { createRunStore, type RunState, type RunStore } from "./run-store.ts";

export class LateRun {
  readonly store: RunStore = createRunStore();
  readonly #nextFrame: (work: () => void) => void;
  #waiting: (() => void)[] = [];

  /** @param nextFrame does something when the browser prepares the next frame: requestAnimationFrame */
  constructor(run: RunStore, nextFrame: (work: () => void) => void) {
    this.#nextFrame = nextFrame;
    run.subscribe((state, before) => {
      this.#catchUp();
      const follow = () => this.store.setState(state, true);
      if (isTurn(before, state)) this.#wait([follow]);
      else follow();
    });
  }

  /** Does what belongs to the newest state: where that waits, after it, and in a frame of its own. */
  after(work: () => void): void {
    if (this.#waiting.length > 0) this.#waiting.push(work);
    else work();
  }

  #wait(works: (() => void)[]): void {
    this.#waiting = works;
    // The frame that is prepared next has the numbers.
    this.#nextFrame(() => this.#goOn(works));
  }

  /** @param works what waited then: news that came since have done it, and wait for themselves */
  #goOn(works: (() => void)[]): void {
    this.#nextFrame(() => {
      if (this.#waiting !== works) return;
      works.shift()?.();
      if (works.length > 0) this.#goOn(works);
    });
  }

  /** News are told in their order: what waits for older ones does not wait any longer. */
  #catchUp(): void {
    const waiting = this.#waiting;
    this.#waiting = [];
    for (const work of waiting) work();
  }
}

/** Whether another line drives, or a manoeuvre begins or ends, in a run that goes on. */
function isTurn(before: RunState, { snapshot, progress }: RunState): boolean {
  return (
    snapshot?.state === "running" &&
    before.snapshot?.state === "running" &&
    (snapshot.line !== before.snapshot.line || (progress === null) !== (before.progress === null))
  );
}
