/**
 * From one page to the next. The page that has the robot may have begun what its relay has not heard of yet,
 * so before another one gets the robot it is asked to begin nothing any more and to say so after all that it
 * has to tell. Where it does not in time, nobody knows what it has begun.
 */
import { closeReasons, type Resume } from "@corridor/protocol";
import type { Clock } from "../clock.ts";
import { reloadReasons, replacedReasons, type LeftReasons } from "../store/session-store.ts";
import { limits } from "./limits.ts";
import type { PageLink } from "./page-link.ts";
import type { PageSeat } from "./page-seat.ts";
import type { RobotLine } from "./robot-line.ts";

export interface PageHandoverParts {
  clock: Clock;
  seat: PageSeat;
  line: RobotLine;
}

/** What is known of the page that had the robot. */
export interface Settled {
  /** its epoch, where it is known what it has not begun; null: it is not known */
  epoch: number | null;
  /** why commands end that it was given */
  left: LeftReasons;
}

/** How a page answers that is asked to give the robot up. */
type Answer = "told all" | "gone" | "silent";

export class PageHandover {
  readonly #clock: Clock;
  readonly #seat: PageSeat;
  readonly #line: RobotLine;
  /** the page here that was asked last */
  #asked: PageLink | null = null;
  /** tells who waits how the page with this epoch has answered */
  #answer: (epoch: number, answer: Answer) => void = () => undefined;

  constructor({ clock, seat, line }: PageHandoverParts) {
    this.#clock = clock;
    this.#seat = seat;
    this.#line = line;
  }

  /** Whether the page that is here gives the robot up, and is not to get anything to begin. */
  get isUnderWay(): boolean {
    return this.#asked !== null && this.#asked === this.#seat.page?.link;
  }

  /**
   * Whether it is the page that had the robot last, on a new line. An earlier Corridor says no name: then
   * only one that is loaded anew is known to be another.
   */
  isSame({ page: name, fresh }: Pick<Resume, "page" | "fresh">): boolean {
    return name === undefined ? !fresh : name === this.#seat.name;
  }

  /**
   * Has the page that has the robot, here or at another relay, give it up.
   * @param resume of the page that comes; where it is the same one on a new line it says itself what it has begun
   */
  async settle(resume: Resume): Promise<Settled> {
    const { epoch, isTaken, isInDoubt } = this.#seat;
    if (this.isSame(resume)) return { epoch, left: reloadReasons };
    const absent: Answer = isInDoubt ? "gone" : "told all";
    const answer = isTaken ? await this.#givenUp(epoch) : absent;
    if (answer === "told all") return { epoch, left: reloadReasons };
    // A reloaded tab closes its connection, or it breaks; one that goes on beside this page is silent.
    const isReload = answer === "gone" && resume.fresh;
    return { epoch: null, left: isReload ? reloadReasons : replacedReasons };
  }

  async #givenUp(epoch: number): Promise<Answer> {
    const { promise, resolve } = Promise.withResolvers<Answer>();
    this.#answer = (of, answer) => {
      if (of === epoch) resolve(answer);
    };
    const cancelTimer = this.#clock.after(limits.yieldMs, () => resolve("silent"));
    if (!this.ask(epoch)) this.#line.yield(epoch);
    const answer = await promise;
    cancelTimer();
    return answer;
  }

  /** Asks the page with this epoch to give the robot up. @returns false where it is not here */
  ask(epoch: number): boolean {
    const { page } = this.#seat;
    if (page?.epoch !== epoch) return false;
    const { link } = page;
    this.#asked = link;
    link.send({ type: "yield" });
    // Nobody came for the robot after all: this page may have it again, on a new line.
    this.#clock.after(2 * limits.yieldMs, () => {
      if (this.#seat.isHeldBy(link)) link.close(closeReasons.busy);
    });
    return true;
  }

  /** The page that is here has told all that it has begun; or the one at another relay has. */
  yielded(epoch: number, isHere: boolean): void {
    if (isHere) this.#line.yielded(epoch);
    this.#answer(epoch, "told all");
  }

  /** The page with this epoch is gone: there will be no other answer. */
  left(epoch: number, saidGoodbye: boolean): void {
    this.#answer(epoch, saidGoodbye ? "told all" : "gone");
  }
}
