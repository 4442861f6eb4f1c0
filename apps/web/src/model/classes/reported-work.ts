/**
 * What was reported of a lesson: the open task, the programs that were tried, and the solutions. The
 * tab stores it, so that a reload reports nothing twice.
 */
import type { KeyValueStorage } from "../storage/key-value-storage.ts";
import { REPORTED_KEY } from "./stored-keys.ts";

interface Stored {
  /** mark of the lesson */
  mark: string | null;
  /** number of the task that was opened last */
  opened: number | null;
  /** the program of the newest run or check, by the number of the task */
  tried: Record<number, string>;
  /** completion codes, by the number of the task; null: a solution without a code */
  solved: Record<number, string | null>;
  hasAnswered: boolean;
}

export class ReportedWork {
  readonly #tab: KeyValueStorage;
  #stored: Stored;

  constructor(tab: KeyValueStorage) {
    this.#tab = tab;
    this.#stored = read(tab.getItem(REPORTED_KEY)) ?? nothingOf(null);
  }

  /** Another lesson: nothing of it was reported. */
  begin(mark: string): void {
    if (mark !== this.#stored.mark) this.#write(nothingOf(mark));
  }

  get hasAnswered(): boolean {
    return this.#stored.hasAnswered;
  }

  answered(): void {
    this.#write({ ...this.#stored, hasAnswered: true });
  }

  /** @returns whether another task was open before */
  open(task: number): boolean {
    if (task === this.#stored.opened) return false;
    this.#write({ ...this.#stored, opened: task });
    return true;
  }

  /** @returns whether another program was tried before */
  try(task: number, program: string): boolean {
    const { tried } = this.#stored;
    if (tried[task] === program) return false;
    this.#write({ ...this.#stored, tried: { ...tried, [task]: program } });
    return true;
  }

  /** @returns whether another solution was reported before, or none */
  solve(task: number, code: string | null): boolean {
    const { solved } = this.#stored;
    if (solved[task] === code) return false;
    this.#write({ ...this.#stored, solved: { ...solved, [task]: code } });
    return true;
  }

  #write(stored: Stored): void {
    this.#stored = stored;
    try {
      this.#tab.setItem(REPORTED_KEY, JSON.stringify(stored));
    } catch {
      // Without storage, a reload may report it again.
    }
  }
}

function nothingOf(mark: string | null): Stored {
  return { mark, opened: null, tried: {}, solved: {}, hasAnswered: false };
}

/** @returns null for anything but what this page has stored */
function read(text: string | null): Stored | null {
  let input: unknown;
  try {
    input = JSON.parse(text ?? "null");
  } catch {
    return null;
  }
  if (typeof input !== "object" || input === null || !("mark" in input)) return null;
  return { ...nothingOf(null), ...(input as Partial<Stored>) };
}
