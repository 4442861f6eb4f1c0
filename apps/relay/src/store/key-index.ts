/** Something for each idempotency key, whose scope is the driver that sent it. */
export class KeyIndex<T> {
  /** by driver: a text made of both would have to be made, and hashed, for each look */
  readonly #byDriver = new Map<string, Map<string, T>>();
  #size = 0;
  /** what was looked for last: most robots have one driver */
  #driver = "";
  #ofDriver: Map<string, T> | undefined;

  get size(): number {
    return this.#size;
  }

  get(driver: string, key: string): T | undefined {
    return this.#of(driver)?.get(key);
  }

  set(driver: string, key: string, value: T): void {
    let ofDriver = this.#of(driver);
    if (ofDriver === undefined) {
      ofDriver = new Map();
      this.#byDriver.set(driver, ofDriver);
      this.#ofDriver = ofDriver;
    }
    const before = ofDriver.size;
    ofDriver.set(key, value);
    this.#size += ofDriver.size - before;
  }

  delete(driver: string, key: string): void {
    const ofDriver = this.#of(driver);
    if (ofDriver?.delete(key) !== true) return;
    this.#size -= 1;
    if (ofDriver.size > 0) return;
    this.#byDriver.delete(driver);
    this.#ofDriver = undefined;
  }

  #of(driver: string): Map<string, T> | undefined {
    if (driver !== this.#driver) {
      this.#driver = driver;
      this.#ofDriver = this.#byDriver.get(driver);
    }
    return this.#ofDriver;
  }
}
