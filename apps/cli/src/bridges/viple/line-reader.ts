/** Splits the bytes of a connection into lines, of at most 16 KiB. */
import { MAX_FRAME_BYTES } from "@corridor/protocol";

const NEW_LINE = 0x0a;

export class LineReader {
  #line = Buffer.alloc(0);
  #isTooLong = false;

  /**
   * @returns the lines that are complete, without their end; null for each that is too long, as soon
   *   as it is
   */
  *add(bytes: Buffer): Generator<string | null> {
    for (let start = 0; ;) {
      const end = bytes.indexOf(NEW_LINE, start);
      const part = bytes.subarray(start, end < 0 ? bytes.length : end);
      if (!this.#isTooLong && this.#line.length + part.length > MAX_FRAME_BYTES) {
        this.#isTooLong = true;
        yield null;
      }
      if (this.#isTooLong) this.#line = Buffer.alloc(0);
      else if (part.length > 0) this.#line = Buffer.concat([this.#line, part]);
      if (end < 0) return;
      // .NET begins a stream with a byte order mark, which counts as white space.
      if (!this.#isTooLong) yield this.#line.toString().trim();
      this.#line = Buffer.alloc(0);
      this.#isTooLong = false;
      start = end + 1;
    }
  }
}
