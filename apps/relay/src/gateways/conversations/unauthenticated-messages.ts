/** Limits the messages that wait in memory until the key of a connection is checked. */
import { limits } from "../../platform/limits/limits.ts";

export class UnauthenticatedMessages {
  #count = 0;
  #bytes = 0;

  /** Counts a message. @returns whether it may wait */
  accepts(bytes: number): boolean {
    this.#count += 1;
    this.#bytes += bytes;
    const { count, bytes: maxBytes } = limits.unauthenticatedMessages;
    return this.#count <= count && this.#bytes <= maxBytes;
  }
}
