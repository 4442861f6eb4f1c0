/** The browser's Storage for tests in Node, which can be full. */
import { VolatileStorage } from "../volatile-storage.ts";

export class MemoryStorage extends VolatileStorage {
  isFull = false;

  override setItem(key: string, value: string): void {
    if (this.isFull) throw new DOMException("The quota has been exceeded.", "QuotaExceededError");
    super.setItem(key, value);
  }
}
