/**
 * Which commands the robot was handed, has begun and has ended: what it says of itself when it comes
 * back to the relay, and how it knows a command that comes again.
 */
export class AppliedCommands {
  /** handed on, neither begun nor ended */
  readonly #waiting = new Set<number>();
  /** given back to the relay, which may send them again */
  readonly #owed = new Set<number>();
  /** ended while an earlier one still waits */
  readonly #endedAhead = new Set<number>();
  #handedOn: number;
  #last: number;

  constructor(lastApplied: number) {
    this.#last = lastApplied;
    this.#handedOn = lastApplied;
  }

  /** This command was begun or ended, and so was every earlier one that the robot holds. */
  get last(): number {
    return this.#last;
  }

  /** Takes note of a command that comes. @returns false when the robot had it before */
  take(seq: number): boolean {
    // Commands come in the order of their numbers: what is skipped was ended by the relay.
    for (const owed of this.#owed) if (owed <= seq) this.#owed.delete(owed);
    if (seq <= this.#handedOn || this.#endedAhead.has(seq)) return false;
    this.#handedOn = seq;
    this.#waiting.add(seq);
    return true;
  }

  /** Commands begin in the order of their numbers. */
  begun(seq: number): void {
    this.#waiting.delete(seq);
    this.#reach(seq);
  }

  ended(seq: number): void {
    this.#waiting.delete(seq);
    const isAhead = [...this.#waiting, ...this.#owed].some((other) => other < seq);
    if (isAhead) this.#endedAhead.add(seq);
    else this.#reach(seq);
  }

  /** Gives back what has not begun: the relay may end it, or send it again. */
  giveBack(): void {
    for (const seq of this.#waiting) this.#owed.add(seq);
    this.#waiting.clear();
    this.#handedOn = this.#last;
  }

  #reach(seq: number): void {
    this.#last = Math.max(this.#last, seq);
    this.#handedOn = Math.max(this.#handedOn, this.#last);
    for (const ended of this.#endedAhead) if (ended <= this.#last) this.#endedAhead.delete(ended);
  }
}
