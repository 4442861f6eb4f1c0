/**
 * The run for output that may be one frame later than the deciding line and the readings: the
 * timeline, the progress of a manoeuvre, highlighted readings, and the texts for screen readers.
 * Every reading comes from the run store itself, so that all of them are of one tick. On a slow
 * computer everything together takes longer than a frame when another line decides.
 */
import { createRunStore, type RunState, type RunStore } from "./run-store.ts";

export class DeferredRun {
  /** for output without readings */
  readonly words: RunStore = createRunStore();
  readonly #defer: (task: () => void) => void;
  /** null while nothing is pending */
  #pending: (() => void)[] | null = null;

  /**
   * @param defer runs a function one frame later. It should use a timer: an animation frame costs
   *   time even if nothing is drawn, and most updates change no mark
   */
  constructor(run: RunStore, defer: (task: () => void) => void) {
    this.#defer = defer;
    run.subscribe((state, before) => {
      this.#flush();
      const words = () => this.words.setState(state, true);
      if (isContinuing(before, state)) this.#schedule(words);
      else words();
    });
  }

  /**
   * Runs a task for the newest state: with its deferred texts if those are pending, otherwise at
   * once.
   */
  with(task: () => void): void {
    if (this.#pending === null) task();
    else this.#pending.push(task);
  }

  #schedule(task: () => void): void {
    const pending = [task];
    this.#pending = pending;
    this.#defer(() => {
      if (this.#pending === pending) this.#flush();
    });
  }

  /** Runs pending tasks before a newer update is published. */
  #flush(): void {
    const pending = this.#pending ?? [];
    this.#pending = null;
    for (const task of pending) task();
  }
}

function isContinuing(before: RunState, { snapshot }: RunState): boolean {
  return snapshot?.state === "running" && before.snapshot?.state === "running";
}
