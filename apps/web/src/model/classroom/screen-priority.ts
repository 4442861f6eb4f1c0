/**
 * Which device controls the big screens of a class: the one on which the teacher chose last what
 * they show. Before that, it is the first one that opened.
 */
import type { RaceChoice } from "./racers.ts";

/** What the teacher has chosen on this device; null: nothing. */
export interface ScreenChoices {
  /** whose run is on the big screens */
  student: number | null;
  /** the maze of the race */
  race: RaceChoice | null;
  /** of the results */
  task: number | null;
}

/** The priority of what this device sends to the big screens. The relay shows the highest one. */
export class ScreenPriority {
  #chosen: ScreenChoices = { student: null, race: null, task: null };
  #priority: number | null = null;

  /**
   * @param now ms since 1970, on the relay's clock, because the clocks of devices differ
   * @param displayed priority of what the big screens show; null: not known
   * @returns the time of the newest choice; before the first one, less than any choice, and less
   * for a device that opened later
   */
  of(chosen: ScreenChoices, now: number, displayed: number | null): number {
    const { student, race, task } = this.#chosen;
    const isSame = chosen.student === student && chosen.race === race && chosen.task === task;
    // This device knows the relay's clock only to some ms.
    if (!isSame) this.#priority = displayed === null ? now : Math.max(now, displayed + 1);
    this.#chosen = chosen;
    this.#priority ??= -now;
    return this.#priority;
  }

  /**
   * Whether another device controls the screens.
   * @param displayed priority of what they show; null: any device can control them
   */
  isLost(displayed: number | null): boolean {
    return displayed !== null && this.#priority !== null && displayed > this.#priority;
  }

  /** The run of a student is not on the screens any more. That is no choice on this device. */
  endRun(): void {
    this.#chosen = { ...this.#chosen, student: null };
  }
}
