/**
 * Whose each entry of the journal is, in order. Entries come at one end and go at the other: a map from which the
 * first are deleted goes over the places of all that were, each time it is asked for its first.
 */

/** Places of what is gone are given back so many at a time. */
const MOST_GONE = 4_096;

export class EntryOwners {
  #entries: number[] = [];
  #owners: string[] = [];
  /** how many of the first are gone */
  #gone = 0;

  get size(): number {
    return this.#entries.length - this.#gone;
  }

  /** @param entry number, higher than those of all before */
  add(entry: number, owner: string): void {
    this.#entries.push(entry);
    this.#owners.push(owner);
  }

  /** The last of the oldest entries, at most so many, that come before this one; 0: none does. */
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
    if (this.#gone >= MOST_GONE) this.#giveBack();
  }

  /** Deletes all that these have. @returns the numbers of the entries */
  deleteOf(owners: ReadonlySet<string>): number[] {
    this.#giveBack();
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

  #giveBack(): void {
    this.#entries.splice(0, this.#gone);
    this.#owners.splice(0, this.#gone);
    this.#gone = 0;
  }
}
