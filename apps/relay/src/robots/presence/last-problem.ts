/** The newest problem of a script, which its owner sees. */
import { MAX_PROBLEM_TEXT, type ScriptView } from "@corridor/protocol";

type Problem = NonNullable<ScriptView["lastProblem"]>;

/** A script that fails in a loop changes the text no faster than a person can read. */
const INTERVAL_MS = 1_000;

export class LastProblem {
  #shown: Problem | null = null;
  #shownAt = -Infinity;
  /** replaces the shown one once that is a second old */
  #next: Problem | null = null;

  /** Whether the text will change without another problem. */
  get isPending(): boolean {
    return this.#next !== null;
  }

  /** @param detail why the relay refused a command, as a sentence */
  record(detail: string, now: number): void {
    const isLong = detail.length > MAX_PROBLEM_TEXT;
    const text = isLong ? `${detail.slice(0, MAX_PROBLEM_TEXT - 1)}…` : detail;
    this.#next = { detail: text, at: new Date(now).toISOString() };
    this.at(now);
  }

  /** The problem to show at this time. */
  at(now: number): Problem | null {
    if (this.#next !== null && now - this.#shownAt >= INTERVAL_MS) {
      this.#shown = this.#next;
      this.#shownAt = now;
      this.#next = null;
    }
    return this.#shown;
  }
}
