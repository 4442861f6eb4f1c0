/** Index of values by idempotency key. Keys are scoped to the driver that sent them. */
export class KeyIndex<T> {
  /** by driver; a combined string would have to be built and hashed for each lookup */
  readonly #byDriver = new Map<string, Map<string, T>>();
  #size = 0;
  /** the last driver looked up, because most robots have one driver */
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
