/** Loads one file of the page, retries after a failure, and notifies its listeners. */

/** `part` is the result of the import. */
export type PartState<Part> =
  | { kind: "none" | "loading" | "failed" }
  | { kind: "ready"; part: Part };

export class PartLoader<Part> {
  readonly #import: () => Promise<Part>;
  readonly #listeners = new Set<() => void>();
  #state: PartState<Part> = { kind: "none" };
  #isPending = false;

  constructor(load: () => Promise<Part>) {
    this.#import = load;
  }

  readonly state = (): PartState<Part> => this.#state;

  /** @returns a function that unsubscribes */
  readonly listen = (listener: () => void): (() => void) => {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  };

  /**
   * Never throws: a failure is a state, and the next call retries. During the retry the state stays
   * "failed", so that the error stays on the screen.
   */
  readonly load = async (): Promise<void> => {
    if (this.#state.kind === "ready" || this.#isPending) return;
    this.#isPending = true;
    if (this.#state.kind === "none") this.#set({ kind: "loading" });
    try {
      this.#set({ kind: "ready", part: await this.#import() });
    } catch {
      this.#set({ kind: "failed" });
    } finally {
      this.#isPending = false;
    }
  };

  #set(state: PartState<Part>): void {
    this.#state = state;
    for (const listener of this.#listeners) listener();
  }
}
