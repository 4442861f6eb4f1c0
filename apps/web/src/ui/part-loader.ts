/** Loads one file of the page at most once for good, again after a failure, and tells who waits for it. */

/** `part` is what the file gave. */
export type PartState<Part> =
  | { kind: "none" | "loading" | "failed" }
  | { kind: "ready"; part: Part };

export class PartLoader<Part> {
  readonly #import: () => Promise<Part>;
  readonly #listeners = new Set<() => void>();
  #state: PartState<Part> = { kind: "none" };
  #isOnItsWay = false;

  constructor(load: () => Promise<Part>) {
    this.#import = load;
  }

  readonly state = (): PartState<Part> => this.#state;

  /** @returns a function that ends it */
  readonly listen = (listener: () => void): (() => void) => {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  };

  /**
   * Never throws: a failure is a state, and the next call tries again. Until that has ended, the state
   * stays "failed", so that what says so stays on the screen.
   */
  readonly load = async (): Promise<void> => {
    if (this.#state.kind === "ready" || this.#isOnItsWay) return;
    this.#isOnItsWay = true;
    if (this.#state.kind === "none") this.#set({ kind: "loading" });
    try {
      this.#set({ kind: "ready", part: await this.#import() });
    } catch {
      this.#set({ kind: "failed" });
    } finally {
      this.#isOnItsWay = false;
    }
  };

  #set(state: PartState<Part>): void {
    this.#state = state;
    for (const listener of this.#listeners) listener();
  }
}
