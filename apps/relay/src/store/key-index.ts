/** Something for each idempotency key, whose scope is the driver that sent it. */
export class KeyIndex<T> {
  /** by driver: a text made of both would have to be made, and hashed, for each look */
  readonly #byDriver = new Map<string, Map<string, T>>();
  #size = 0;

  get size(): number {
    return this.#size;
  }

  get(driver: string, key: string): T | undefined {
    return this.#byDriver.get(driver)?.get(key);
  }

  set(driver: string, key: string, value: T): void {
    let ofDriver = this.#byDriver.get(driver);
    if (ofDriver === undefined) {
      ofDriver = new Map();
      this.#byDriver.set(driver, ofDriver);
    }
    const before = ofDriver.size;
    ofDriver.set(key, value);
    this.#size += ofDriver.size - before;
  }

  delete(driver: string, key: string): void {
    const ofDriver = this.#byDriver.get(driver);
    if (ofDriver?.delete(key) !== true) return;
    this.#size -= 1;
    if (ofDriver.size === 0) this.#byDriver.delete(driver);
  }
}
