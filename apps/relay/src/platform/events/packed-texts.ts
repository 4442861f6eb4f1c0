/**
 * Queue of texts in one buffer. New texts go to the end, and the oldest are removed first. V8's
 * garbage collector does not traverse them, however many there are. Lone surrogates are not
 * preserved, but the output of JSON.stringify contains none.
 */

const FIRST_BYTES = 1_024;
/**
 * Buffer size in multiples of the needed bytes. Outside of `least` to `most`, a buffer of `made`
 * times that size replaces it.
 */
const ROOM = { least: 1.25, made: 1.5, most: 2 };

const nothing = Buffer.alloc(0);

export class PackedTexts {
  #bytes = nothing;
  /** offset of the oldest text */
  #start = 0;
  /** end offset of each text */
  #ends: number[] = [];

  get length(): number {
    return this.#ends.length;
  }

  push(text: string): void {
    const size = Buffer.byteLength(text);
    const end = this.#ends.at(-1) ?? this.#start;
    const at = end + size <= this.#bytes.length ? end : this.#makeRoom(size);
    this.#bytes.write(text, at);
    this.#ends.push(at + size);
  }

  /** @param at index; 0: the oldest */
  at(at: number): string {
    return this.#bytes.toString("utf8", this.#ends[at - 1] ?? this.#start, this.#ends[at]);
  }

  /** Size of the texts in bytes. */
  get size(): number {
    return (this.#ends.at(-1) ?? this.#start) - this.#start;
  }

  /** Size of the buffer in bytes, including free space. */
  get bytes(): number {
    return this.#bytes.length;
  }

  /** Removes the oldest texts. */
  shift(count: number): void {
    this.#start = this.#ends[count - 1] ?? this.#start;
    if (count === 1) this.#ends.shift();
    else this.#ends.splice(0, count);
    if (this.#ends.length > 0) return;
    this.#bytes = nothing;
    this.#start = 0;
  }

  /**
   * Moves the texts to the front and makes room for `size` more bytes. @returns their end offset
   */
  #makeRoom(size: number): number {
    const stored = this.#bytes.subarray(this.#start, this.#ends.at(-1) ?? this.#start);
    const needed = Math.max(stored.length + size, FIRST_BYTES / ROOM.made);
    const now = this.#bytes.length;
    const isRight = now >= needed * ROOM.least && now <= needed * ROOM.most;
    const bytes = isRight ? this.#bytes : Buffer.allocUnsafeSlow(Math.ceil(needed * ROOM.made));
    stored.copy(bytes);
    this.#ends = this.#ends.map((end) => end - this.#start);
    this.#bytes = bytes;
    this.#start = 0;
    return stored.length;
  }
}
