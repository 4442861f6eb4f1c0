/**
 * Brings the reader of stored works: before the page opens where something is stored, in the
 * background where nothing is.
 */
import type { ReadWork } from "./works.ts";

export class WorkReader {
  #read: ReadWork | null = null;

  /** null until it has been loaded */
  get read(): ReadWork | null {
    return this.#read;
  }

  /** @throws when its file does not come; calling again tries again */
  async load(): Promise<void> {
    const { readWork } = await import("./read-work.ts");
    this.#read = readWork;
  }
}
