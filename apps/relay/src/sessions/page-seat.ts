/** Who the robot is at the moment: the page that took it last, or nobody, and since when. */
import type { PageLink } from "./page-link.ts";

export interface SeatedPage {
  link: PageLink;
  epoch: number;
}

export class PageSeat {
  #page: SeatedPage | null = null;
  /** null also once what a page left behind has been seen to */
  #awaySince: number | null;

  /** @param now a robot that nobody has taken yet counts as away from here on */
  constructor(now: number) {
    this.#awaySince = now;
  }

  get page(): SeatedPage | null {
    return this.#page;
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
    this.#awaySince = null;
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
