/** A web lock, held while a robot runs, so that browsers do not freeze the hidden page. */

const NAME = "corridor-simulation";

export class SimulationLock {
  #release: (() => void) | null = null;

  /** Acquires or releases the lock. */
  hold(isWanted: boolean): void {
    if (isWanted === (this.#release !== null)) return;
    this.#release?.();
    this.#release = null;
    if (!isWanted) return;
    const held = new Promise<void>((resolve) => (this.#release = resolve));
    // Without the Web Locks API (insecure origins) the robot runs all the same, but browsers may
    // freeze it.
    void navigator.locks?.request(NAME, { mode: "shared" }, () => held);
  }
}
