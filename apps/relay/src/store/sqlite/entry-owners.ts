/**
 * The robot of each journal entry, in order. Entries are added at the end and removed from the
 * start. A Map would be slow here: after deletions at its start, each iteration first skips all
 * deleted slots.
 */

/** Number of removed entries after which their slots are freed. */
const MOST_GONE = 4_096;

export class EntryOwners {
  #entries: number[] = [];
  #owners: string[] = [];
  /** number of removed entries at the start of the lists */
  #gone = 0;

  get size(): number {
    return this.#entries.length - this.#gone;
  }

  /** @param entry number, higher than all previous ones */
  add(entry: number, owner: string): void {
    this.#entries.push(entry);
    this.#owners.push(owner);
  }

  /**
   * The number of the newest among the `most` oldest entries that precede `before`; 0 if there is
   * none.
   */
  lastOfOldest(most: number, before: number): number {
    let last = 0;
    const end = Math.min(this.#entries.length, this.#gone + most);
    for (let at = this.#gone; at < end; at++) {
      const entry = this.#entries[at] ?? before;
      if (entry >= before) break;
      last = entry;
    }
    return last;
  }

  deleteUpTo(entry: number): void {
    while ((this.#entries[this.#gone] ?? Infinity) <= entry) this.#gone += 1;
    if (this.#gone >= MOST_GONE) this.#compact();
  }

  /** Deletes all entries of these owners. @returns the numbers of the entries */
  deleteOf(owners: ReadonlySet<string>): number[] {
    this.#compact();
    const isGone = this.#owners.map((owner) => owners.has(owner));
    const deleted = this.#entries.filter((_, at) => isGone[at]);
    this.#entries = this.#entries.filter((_, at) => !isGone[at]);
    this.#owners = this.#owners.filter((_, at) => !isGone[at]);
    return deleted;
  }

  clear(): void {
    this.#entries = [];
    this.#owners = [];
    this.#gone = 0;
  }

  #compact(): void {
    this.#entries.splice(0, this.#gone);
    this.#owners.splice(0, this.#gone);
    this.#gone = 0;
  }
}
