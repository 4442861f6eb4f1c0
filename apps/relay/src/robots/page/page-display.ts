/**
 * Shows the page commands that it does not have: those that wait, and those that ended without it.
 * The display is for people. It is immediate at low rates, and batched once a second at high rates.
 */
import type { RelayToPage } from "@corridor/protocol";
import type { Clock } from "../../platform/time/clock.ts";
import type { CoalescedTimers, Waiter } from "../../platform/time/coalesced-timers.ts";
import type { TermedRecord } from "../../store/port.ts";
import { limits } from "../../platform/limits/limits.ts";
import type { PageLink, PageOwnership, OwningPage } from "./page-ownership.ts";

export class PageDisplay implements Waiter {
  readonly #ownership: PageOwnership;
  readonly #clock: Clock;
  readonly #timers: CoalescedTimers;
  /** epoch of the page that the held commands are for */
  #epoch = 0;
  #shownAt = -Infinity;
  #held: TermedRecord[] = [];
  /** whether a timer is pending */
  #isArmed = false;

  constructor({
    ownership,
    clock,
    timers,
  }: {
    ownership: PageOwnership;
    clock: Clock;
    timers: CoalescedTimers;
  }) {
    this.#ownership = ownership;
    this.#clock = clock;
    this.#timers = timers;
  }

  show(commands: readonly TermedRecord[]): void {
    const page = this.#page();
    if (page === null) return;
    this.#held.push(...commands);
    this.#showWhenDue(page.link);
  }

  /** Sends a message to the page, after the held commands. */
  sendWith(message: RelayToPage): void {
    const page = this.#page();
    if (page !== null) this.#send(page.link, message);
  }

  /** Shows the held commands. Callers flush before the page receives one of them. */
  flush(): void {
    const page = this.#page();
    if (page !== null && this.#held.length > 0) this.#send(page.link);
  }

  wake(): void {
    this.#isArmed = false;
    this.show([]);
  }

  /** The connected page. Discards commands that were held for a previous page. */
  #page(): OwningPage | null {
    const { page } = this.#ownership;
    const epoch = page?.epoch ?? 0;
    if (epoch === this.#epoch) return page;
    this.#epoch = epoch;
    this.#held = [];
    this.#shownAt = -Infinity;
    return page;
  }

  #showWhenDue(link: PageLink): void {
    if (this.#held.length === 0) return;
    const waitMs = this.#shownAt + limits.shownIntervalMs - this.#clock.now();
    if (waitMs <= 0) return this.#send(link);
    if (this.#isArmed) return;
    this.#isArmed = true;
    this.#timers.wakeAfter(waitMs, this);
  }

  #send(link: PageLink, ...more: RelayToPage[]): void {
    const shown = this.#held.map(({ record, ttl }): RelayToPage => ({
      type: "state",
      record,
      ttl,
    }));
    if (shown.length > 0) this.#shownAt = this.#clock.now();
    this.#held = [];
    link.send(...shown, ...more);
  }
}
