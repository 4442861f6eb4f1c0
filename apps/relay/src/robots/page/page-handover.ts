/**
 * Transfers a robot from one page to the next. The owning page may have started commands that its
 * relay does not know of yet. So the relay asks it to start nothing more, and to confirm after its
 * last report. Without a confirmation in time, it is unknown which commands it has started.
 */
import { closeReasons, type Resume } from "@corridor/protocol";
import type { Clock } from "../../platform/time/clock.ts";
import type { LeftCause } from "../../commands/reasons.ts";
import { limits } from "../../platform/limits/limits.ts";
import type { PageOwnership } from "./page-ownership.ts";
import type { RobotChannel } from "../channel/robot-channel.ts";

export interface PageHandoverParts {
  clock: Clock;
  ownership: PageOwnership;
  channel: Pick<RobotChannel, "yield" | "yielded">;
}

/** What is known about the page that owned the robot. */
export interface PreviousPage {
  /** its epoch, if it is known which commands it has not started; null: unknown */
  epoch: number | null;
  /** why its commands end */
  left: LeftCause;
}

/** How the owning page responds to the request to release the robot. */
type Answer = "reported all" | "gone" | "silent";

export class PageHandover {
  readonly #clock: Clock;
  readonly #ownership: PageOwnership;
  readonly #channel: PageHandoverParts["channel"];
  /** reports how the page with this epoch responded */
  #answer: (epoch: number, answer: Answer) => void = () => undefined;

  constructor({ clock, ownership, channel }: PageHandoverParts) {
    this.#clock = clock;
    this.#ownership = ownership;
    this.#channel = channel;
  }

  /**
   * Whether this is the page that owned the robot last, on a new connection. Earlier versions of
   * Corridor send no name. Then only a newly loaded page counts as another page.
   */
  isSame({ page: name, fresh }: Pick<Resume, "page" | "fresh">): boolean {
    return name === undefined ? !fresh : name === this.#ownership.name;
  }

  /**
   * Makes the owning page, here or at another relay, release the robot.
   * @param resume of the new page; the same page on a new connection reports what it has started
   */
  async releasePrevious(resume: Resume): Promise<PreviousPage> {
    const { epoch, isOwned, isInDoubt } = this.#ownership;
    if (this.isSame(resume)) return { epoch, left: "reloaded" };
    const absent: Answer = isInDoubt ? "gone" : "reported all";
    const answer = isOwned ? await this.#givenUp(epoch) : absent;
    if (answer === "reported all") return { epoch, left: "reloaded" };
    // A reloaded tab closes its connection, or the connection breaks. A page that stays open beside
    // the new one is silent.
    const isReload = answer === "gone" && resume.fresh;
    return { epoch: null, left: isReload ? "reloaded" : "taken-over" };
  }

  async #givenUp(epoch: number): Promise<Answer> {
    const { promise, resolve } = Promise.withResolvers<Answer>();
    this.#answer = (of, answer) => {
      if (of === epoch) resolve(answer);
    };
    const cancelTimer = this.#clock.after(limits.yieldMs, () => resolve("silent"));
    if (!this.ask(epoch)) this.#channel.yield(epoch);
    const answer = await promise;
    cancelTimer();
    return answer;
  }

  /**
   * Asks the page with this epoch to release the robot. @returns false if it is not at this relay
   */
  ask(epoch: number): boolean {
    const { page } = this.#ownership;
    if (page?.epoch !== epoch) return false;
    const { connection } = page;
    page.isReleasing = true;
    connection.send({ type: "yield" });
    // No other page acquired the robot. This page may reconnect and own it again.
    this.#clock.after(2 * limits.yieldMs, () => {
      if (this.#ownership.isHeldBy(connection)) connection.close(closeReasons.busy);
    });
    return true;
  }

  /**
   * The page with this epoch has reported all that it started.
   * @param isHere whether that page is at this relay
   */
  yielded(epoch: number, isHere: boolean): void {
    if (isHere) this.#channel.yielded(epoch);
    this.#answer(epoch, "reported all");
  }

  /** The page with this epoch disconnected, so no other response follows. */
  left(epoch: number, closedByPage: boolean): void {
    this.#answer(epoch, closedByPage ? "reported all" : "gone");
  }
}
