/**
 * Tracks which commands the robot has received, started and ended, to report its progress after a
 * reconnect and to recognise repeated commands.
 */
export class AppliedCommands {
  /** received, neither started nor ended */
  readonly #waiting = new Set<number>();
  /** returned to the relay, which may send them again */
  readonly #returned = new Set<number>();
  /** ended while an earlier one waits */
  readonly #endedEarly = new Set<number>();
  #lastReceived: number;
  #last: number;

  constructor(lastApplied: number) {
    this.#last = lastApplied;
    this.#lastReceived = lastApplied;
  }

  /** The highest seq up to which all received commands have started or ended. */
  get last(): number {
    return this.#last;
  }

  /** Records a received command. @returns false if the robot had it before */
  receive(seq: number): boolean {
    // Commands arrive in order of their seq: the relay has ended those that are missing.
    for (const returned of this.#returned) if (returned <= seq) this.#returned.delete(returned);
    if (seq <= this.#lastReceived || this.#endedEarly.has(seq)) return false;
    this.#lastReceived = seq;
    this.#waiting.add(seq);
    return true;
  }

  /** Commands start in order of their seq. */
  started(seq: number): void {
    this.#waiting.delete(seq);
    this.#advance(seq);
  }

  ended(seq: number): void {
    this.#waiting.delete(seq);
    const isEarly = [...this.#waiting, ...this.#returned].some((other) => other < seq);
    if (isEarly) this.#endedEarly.add(seq);
    else this.#advance(seq);
  }

  /** Returns unstarted commands to the relay, which may end them or send them again. */
  returnUnstarted(): void {
    for (const seq of this.#waiting) this.#returned.add(seq);
    this.#waiting.clear();
    this.#lastReceived = this.#last;
  }

  #advance(seq: number): void {
    this.#last = Math.max(this.#last, seq);
    this.#lastReceived = Math.max(this.#lastReceived, this.#last);
    for (const ended of this.#endedEarly) if (ended <= this.#last) this.#endedEarly.delete(ended);
  }
}
