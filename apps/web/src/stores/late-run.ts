/**
 * The run for the parts that have the page laid out anew: the mark of the line that drives, its note, the
 * timeline. Of a turn of the program they hear one frame after the numbers: on a slow computer both
 * together are longer than a frame, and the stage would stand still.
 */
import { createRunStore, type RunState, type RunStore } from "./run-store.ts";

export class LateRun {
  readonly store: RunStore = createRunStore();
  readonly #nextFrame: (work: () => void) => void;
  #waiting: (() => void)[] = [];

  /** @param nextFrame does something when the frame that the browser prepares now has been shown */
  constructor(run: RunStore, nextFrame: (work: () => void) => void) {
    this.#nextFrame = nextFrame;
    run.subscribe((state, before) => {
      this.#catchUp();
      const follow = () => this.store.setState(state, true);
      if (isTurn(before, state)) this.#wait(follow);
      else follow();
    });
  }

  /** Does what belongs to the newest state: where that waits, after it, and in a frame of its own. */
  after(work: () => void): void {
    if (this.#waiting.length > 0) this.#wait(work);
    else work();
  }

  #wait(work: () => void): void {
    this.#waiting.push(work);
    if (this.#waiting.length === 1) this.#goOn();
  }

  #goOn(): void {
    const [first] = this.#waiting;
    this.#nextFrame(() => {
      // What newer news have overtaken is done.
      if (first === undefined || this.#waiting[0] !== first) return;
      this.#waiting.shift();
      first();
      if (this.#waiting.length > 0) this.#goOn();
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
