/** Runs tasks one after the other, in the order in which they were given. */
export class SerialQueue {
  #newest: Promise<unknown> = Promise.resolve();

  /** Runs a task in its turn. A failed task does not stop the next one. */
  run<T>(change: () => Promise<T>): Promise<T> {
    const result = this.#newest.then(change);
    this.#newest = result.catch(() => undefined);
    return result;
  }
}
