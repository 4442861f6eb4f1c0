/** One change after the other: what was begun first is over before the next begins. */
export class OrderedWork {
  #newest: Promise<unknown> = Promise.resolve();

  /** Runs a change in its turn; one that fails does not stop the next. */
  run<T>(change: () => Promise<T>): Promise<T> {
    const result = this.#newest.then(change);
    this.#newest = result.catch(() => undefined);
    return result;
  }
}
