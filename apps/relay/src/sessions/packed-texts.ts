/**
 * Texts in order, as bytes: new ones come at one end, old ones go at the other. However many there are, they are no
 * objects that V8 goes through when it looks for garbage. Half a surrogate pair does not come back as it was; JSON
 * has none.
 */

const FIRST_BYTES = 1_024;
/** Bytes are moved to others, half again what is needed, where these are too few or too many times that. */
const ROOM = { least: 1.25, made: 1.5, most: 2 };

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

  /** What they take, with what is free for more. */
  get bytes(): number {
    return this.#bytes.length;
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

  /** Moves what is kept to the front, so that so many bytes more have room. @returns where it ends */
  #makeRoom(size: number): number {
    const kept = this.#bytes.subarray(this.#start, this.#ends.at(-1) ?? this.#start);
    const needed = Math.max(kept.length + size, FIRST_BYTES / ROOM.made);
    const now = this.#bytes.length;
    const isRight = now >= needed * ROOM.least && now <= needed * ROOM.most;
    const bytes = isRight ? this.#bytes : Buffer.allocUnsafeSlow(Math.ceil(needed * ROOM.made));
    kept.copy(bytes);
    this.#ends = this.#ends.map((end) => end - this.#start);
    this.#bytes = bytes;
    this.#start = 0;
    return kept.length;
  }
}
