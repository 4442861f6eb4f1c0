/**
 * Announces students who need help now, at most once in 10 s. Without anybody new, no timer runs.
 */
const INTERVAL_MS = 10_000;

interface AnnouncerPorts {
  /** @param students who need help since the last call; empty: nobody does any more */
  announce: (students: readonly number[]) => void;
  /** monotonic milliseconds */
  now: () => number;
  /** @returns a function that cancels the call */
  later: (call: () => void, ms: number) => () => void;
}

export class HelpAnnouncer {
  readonly #ports: AnnouncerPorts;
  #helped: ReadonlySet<number> = new Set();
  /** who has been announced and still needs help */
  #announced = new Set<number>();
  #announcedAt = Number.NEGATIVE_INFINITY;
  #cancel: (() => void) | null = null;

  constructor(ports: AnnouncerPorts) {
    this.#ports = ports;
  }

  /** @param helped who needs help now */
  follow(helped: ReadonlySet<number>): void {
    this.#helped = helped;
    const hadSome = this.#announced.size > 0;
    this.#announced = new Set([...this.#announced].filter((student) => helped.has(student)));
    if (this.#new().length === 0) {
      this.stop();
      // Another text of the same student must be another change.
      if (hadSome && this.#announced.size === 0) this.#ports.announce([]);
      return;
    }
    const waitMs = Math.max(0, this.#announcedAt + INTERVAL_MS - this.#ports.now());
    this.#cancel ??= this.#ports.later(() => this.#announce(), waitMs);
  }

  stop(): void {
    this.#cancel?.();
    this.#cancel = null;
  }

  #announce(): void {
    this.#cancel = null;
    const students = this.#new();
    this.#announced = new Set(this.#helped);
    this.#announcedAt = this.#ports.now();
    this.#ports.announce(students);
  }

  #new(): number[] {
    return [...this.#helped].filter((student) => !this.#announced.has(student));
  }
}
