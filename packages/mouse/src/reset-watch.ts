/** Notices that the robot was put back to its start, by its page: its ticks begin again. */
import type { Snapshot } from "@corridor/protocol";

export class ResetWatch {
  #tick: number;
  #isOwn = false;
  #isPending = false;
  #count = 0;
  readonly #waiting = new Set<() => void>();

  constructor(newest: Snapshot | null) {
    this.#tick = newest?.tick ?? 0;
  }

  /** Whether the program has not acknowledged a reset yet. */
  get isPending(): boolean {
    return this.#isPending;
  }

  /** Number of resets by the page. */
  get count(): number {
    return this.#count;
  }

  update({ tick }: Snapshot): void {
    const isReset = tick < this.#tick && !this.#isOwn;
    this.#tick = tick;
    if (!isReset) return;
    this.#isPending = true;
    this.#count += 1;
    for (const notify of this.#waiting) notify();
    this.#waiting.clear();
  }

  /** Runs the program's own reset, which acknowledges those before it. */
  async during(reset: () => Promise<unknown>): Promise<void> {
    this.#isOwn = true;
    try {
      await reset();
    } finally {
      this.#isOwn = false;
      this.#isPending = false;
    }
  }

  /** Calls `notify` once at the next reset. @returns a function that cancels it */
  onNext(notify: () => void): () => void {
    this.#waiting.add(notify);
    return () => void this.#waiting.delete(notify);
  }
}
