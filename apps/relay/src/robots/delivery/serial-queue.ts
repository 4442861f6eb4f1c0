/** Serial queue: each task starts after the previous one has finished. */
export class SerialQueue {
  #newest: Promise<unknown> = Promise.resolve();

  /** Runs a task in its turn. A failed task does not stop the next one. */
  run<T>(change: () => Promise<T>): Promise<T> {
    const result = this.#newest.then(change);
    this.#newest = result.catch(() => undefined);
    return result;
  }
}
