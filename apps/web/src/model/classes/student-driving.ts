/**
 * Whether a student drives now, by hand or by a script. A drive has pauses: between two commands the
 * robot stands still, but the student does not write.
 */
import type { DriverName } from "@corridor/protocol";

export class StudentDriving {
  #driver: DriverName = "program";
  #tick = 0;
  /** tick of the newest edit: what drove before it does not count; null: not edited in this run */
  #editedAt: number | null = null;

  /** @param tick the newest one of the live run @returns whether `isOn` has changed */
  follow(driver: DriverName, tick: number): boolean {
    const before = this.isOn;
    // After a reset, the next tick is a new one.
    if (this.#editedAt !== null && tick < this.#editedAt) this.#editedAt = tick;
    this.#driver = driver;
    this.#tick = tick;
    return this.isOn !== before;
  }

  /** The program was edited. */
  edited(): void {
    this.#editedAt = this.#tick;
  }

  get isOn(): boolean {
    return this.#driver !== "program" && (this.#editedAt === null || this.#tick > this.#editedAt);
  }
}
