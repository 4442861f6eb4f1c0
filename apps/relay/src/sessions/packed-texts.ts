/**
 * Texts in order, as bytes: new ones come at one end, old ones go at the other. However many there are, they are one
 * object, and nothing that V8 has to go through when it looks for garbage.
 */

/** Bytes for the first texts; doubled whenever they are full. */
const FIRST_BYTES = 1_024;

const nothing = Buffer.alloc(0);

export class PackedTexts {
  #bytes = nothing;
  /** where the oldest begins */
  #start = 0;
  /** where each ends */
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

  /** @param at 0: the oldest */
  at(at: number): string {
    return this.#bytes.toString("utf8", this.#ends[at - 1] ?? this.#start, this.#ends[at]);
  }

  /** Lets go of the oldest ones. */
  shift(count: number): void {
    this.#start = this.#ends[count - 1] ?? this.#start;
    if (count === 1) this.#ends.shift();
    else this.#ends.splice(0, count);
    if (this.#ends.length > 0) return;
    this.#bytes = nothing;
    this.#start = 0;
  }

  /** Moves what is kept to the front, of more bytes where they were not half empty. @returns where it ends */
  #makeRoom(size: number): number {
    const kept = this.#bytes.subarray(this.#start, this.#ends.at(-1) ?? this.#start);
    let room = Math.max(this.#bytes.length, FIRST_BYTES);
    while (room < 2 * kept.length || room < kept.length + size) room *= 2;
    const bytes = room === this.#bytes.length ? this.#bytes : Buffer.allocUnsafeSlow(room);
    kept.copy(bytes);
    this.#ends = this.#ends.map((end) => end - this.#start);
    this.#bytes = bytes;
    this.#start = 0;
    return kept.length;
  }
}
