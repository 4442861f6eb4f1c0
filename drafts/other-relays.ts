/**
 * What the other relays report of one class: which students are connected and watched there. A
 * relay that reports nothing for a while no longer counts.
 */
import type { Clock } from "../platform/time/clock.ts";
import { limits } from "../platform/limits/limits.ts";

interface Report {
  connected: ReadonlySet<number>;
  watched: ReadonlySet<number>;
  at: number;
}

export class OtherRelays {
  readonly #clock: Clock;
  readonly #reports = new Map<string, Report>();

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  get isEmpty(): boolean {
    return this.#reports.size === 0;
  }

  isConnected(student: number): boolean {
    return [...this.#reports.values()].some(({ connected }) => connected.has(student));
  }

  isWatched(student: number): boolean {
    return [...this.#reports.values()].some(({ watched }) => watched.has(student));
  }

  /** @returns the students for whom something may have changed */
  reported(
    relay: string,
    { connected, watched }: { connected: readonly number[]; watched: readonly number[] },
  ): number[] {
    const before = this.#reports.get(relay);
    const at = this.#clock.now();
    const now: Report = { connected: new Set(connected), watched: new Set(watched), at };
    this.#reports.set(relay, now);
    return differences(before, now);
  }

  /** @returns the students for whom something may have changed */
  left(relay: string): number[] {
    const before = this.#reports.get(relay);
    this.#reports.delete(relay);
    return differences(before, undefined);
  }

  /** Removes relays without a report. @returns the students for whom something may have changed */
  removeSilent(): number[] {
    const oldest = this.#clock.now() - limits.classSilenceMs;
    const silent = [...this.#reports].filter(([, { at }]) => at < oldest);
    return silent.flatMap(([relay]) => this.left(relay));
  }
}

function differences(before: Report | undefined, now: Report | undefined): number[] {
  const nobody: ReadonlySet<number> = new Set();
  const connected = (before?.connected ?? nobody).symmetricDifference(now?.connected ?? nobody);
  const watched = (before?.watched ?? nobody).symmetricDifference(now?.watched ?? nobody);
  return [...connected.union(watched)];
}
