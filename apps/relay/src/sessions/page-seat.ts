/** Who the robot is at the moment: the page that took it last, here or at another relay, or nobody, and since when. */
import type { PageLink } from "./page-link.ts";

export interface SeatedPage {
  link: PageLink;
  epoch: number;
  /** by which it is known on each of its lines; empty where it says none */
  name: string;
}

export class PageSeat {
  #page: SeatedPage | null = null;
  /** epoch of the page that another relay has; null: none has */
  #elsewhere: number | null = null;
  /** the highest that is known */
  #epoch: number;
  /** of the page with that epoch; empty where it is not known */
  #name: string;
  /** the page that left last has not told all that it had begun, as far as anybody knows */
  #isInDoubt: boolean;
  /** null also once what a page left behind has been seen to */
  #awaySince: number | null;

  /**
   * @param now a robot that nobody has taken yet counts as away from here on
   * @param last the page that took it last; epoch 0: none has
   */
  constructor(now: number, last: { epoch: number; page: string }) {
    this.#awaySince = now;
    this.#epoch = last.epoch;
    this.#name = last.page;
    this.#isInDoubt = last.epoch > 0;
  }

  get page(): SeatedPage | null {
    return this.#page;
  }

  /** Of the page that took the robot last, as far as is known. */
  get epoch(): number {
    return this.#epoch;
  }

  /** Of the same page; empty where it is not known. */
  get name(): string {
    return this.#name;
  }

  get isElsewhere(): boolean {
    return this.#elsewhere !== null;
  }

  /** Whether a page has the robot, here or at another relay. */
  get isTaken(): boolean {
    return this.#page !== null || this.isElsewhere;
  }

  /** Whether something is due once the page has been away for long enough. */
  get isAwayOpen(): boolean {
    return this.#awaySince !== null;
  }

  /** Whether nobody has the robot, and the page that had it last may have begun more than it told. */
  get isInDoubt(): boolean {
    return this.#isInDoubt;
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
    this.#name = page.name;
    this.#elsewhere = null;
    this.#isInDoubt = false;
    this.#awaySince = null;
  }

  /**
   * A page has taken the robot at another relay.
   * @returns the page that was here until then
   */
  takeElsewhere(epoch: number, name: string): SeatedPage | null {
    if (epoch < this.#epoch) return null;
    const before = this.#page;
    this.#page = null;
    this.#epoch = epoch;
    this.#name = name;
    this.#elsewhere = epoch;
    this.#isInDoubt = false;
    this.#awaySince = null;
    return before;
  }

  /** The page at another relay is away. @returns false when it was not the newest */
  leaveElsewhere(epoch: number, now: number, saidGoodbye: boolean): boolean {
    if (this.#elsewhere !== epoch) return false;
    this.#isInDoubt = !saidGoodbye;
    this.#elsewhere = null;
    this.#awaySince = now;
    return true;
  }

  leave(now: number, saidGoodbye: boolean): void {
    this.#isInDoubt = !saidGoodbye;
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
