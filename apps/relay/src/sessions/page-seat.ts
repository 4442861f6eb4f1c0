/** Who the robot is at the moment: the page that took it last, here or at another relay, or nobody, and since when. */
import type { PageLink } from "./page-link.ts";

export interface SeatedPage {
  link: PageLink;
  epoch: number;
}

export class PageSeat {
  #page: SeatedPage | null = null;
  /** epoch of the page that another relay has; null: none has */
  #elsewhere: number | null = null;
  /** the highest that is known */
  #epoch: number;
  /** null also once what a page left behind has been seen to */
  #awaySince: number | null;

  /**
   * @param now a robot that nobody has taken yet counts as away from here on
   * @param epoch of the page that took it last
   */
  constructor(now: number, epoch: number) {
    this.#awaySince = now;
    this.#epoch = epoch;
  }

  get page(): SeatedPage | null {
    return this.#page;
  }

  /** Of the page that took the robot last, as far as is known. */
  get epoch(): number {
    return this.#epoch;
  }

  get isElsewhere(): boolean {
    return this.#elsewhere !== null;
  }

  /** Whether something is due once the page has been away for long enough. */
  get isAwayOpen(): boolean {
    return this.#awaySince !== null;
  }

  isHeldBy(link: PageLink): boolean {
    return this.#page?.link === link;
  }

  awayMs(now: number): number {
    return this.#awaySince === null ? 0 : now - this.#awaySince;
  }

  take(page: SeatedPage): void {
    this.#page = page;
    this.#epoch = page.epoch;
    this.#elsewhere = null;
    this.#awaySince = null;
  }

  /**
   * A page has taken the robot at another relay.
   * @returns the page that was here until then
   */
  takeElsewhere(epoch: number): SeatedPage | null {
    if (epoch < this.#epoch) return null;
    const before = this.#page;
    this.#page = null;
    this.#epoch = epoch;
    this.#elsewhere = epoch;
    this.#awaySince = null;
    return before;
  }

  /** The page at another relay is away. @returns false when it was not the newest */
  leaveElsewhere(epoch: number, now: number): boolean {
    if (this.#elsewhere !== epoch) return false;
    this.#elsewhere = null;
    this.#awaySince = now;
    return true;
  }

  leave(now: number): void {
    this.#page = null;
    this.#awaySince = now;
  }

  /** What the page left behind has been seen to. */
  settleAway(): void {
    this.#awaySince = null;
  }

  /** Nobody is the robot any more, and nothing is due. */
  clear(): void {
    this.#page = null;
    this.#awaySince = null;
  }
}
