/**
 * Sends commands to the page: delivers those that it may have, in order, and shows it those that it
 * does not have. A command is marked as delivered before it is sent.
 */
import { closeReasons, type CommandRecord, type RelayToPage } from "@corridor/protocol";
import { deliverStep } from "../../commands/state-machine.ts";
import { keyId } from "../../platform/keys.ts";
import type { Clock } from "../../platform/time/clock.ts";
import type { RobotStore } from "../../store/robot-store.ts";
import type { TermedRecord } from "../../commands/robot-commands.ts";
import { limits } from "../../platform/limits/limits.ts";
import type { PageConnection, PageOwnership, OwningPage } from "../page/page-ownership.ts";
import type { CoalescedTimers, Waiter } from "../../platform/time/coalesced-timers.ts";

/** Commands that are marked as delivered and are to be sent now. */
export interface Due {
  connection: PageConnection;
  commands: TermedRecord[];
  /** when they were marked */
  now: number;
}

export interface CommandDeliveryParts {
  robot: string;
  store: Pick<RobotStore, "commit" | "current">;
  clock: Clock;
  ownership: PageOwnership;
  display: PageDisplay;
  /** called with the delivered records */
  sent(records: readonly CommandRecord[]): void;
}

export class CommandDelivery {
  readonly #parts: CommandDeliveryParts;

  constructor(parts: CommandDeliveryParts) {
    this.#parts = parts;
  }

  /** Delivers all commands that the page may have now. */
  async run(): Promise<void> {
    this.send(await this.take());
  }

  /**
   * Marks the commands that the page may have now as delivered. If the preceding store step starts
   * in the same turn, one commit stores both. The page then has a command as soon as its sender has
   * the response.
   * @returns what to send, whether or not the preceding step succeeds; null: there is nothing to
   * deliver, or no page to deliver to
   */
  async take(): Promise<Due | null> {
    const { robot, store, clock, ownership } = this.#parts;
    const { page } = ownership;
    if (page === null || page.isReleasing) return null;
    const { connection, epoch } = page;
    const now = clock.now();
    try {
      // After most commands there is nothing more to deliver, which needs no query to detect.
      if (store.current(robot)?.isWindowFull(limits.deliveredWindow) === true) return null;
      return {
        connection,
        commands: await store.commit(robot, deliverStep(epoch, limits.deliveredWindow, now)),
        now,
      };
    } catch {
      // The commands stay stored. The page reconnects after this close code and receives them then.
      connection.close(closeReasons.busy);
      return null;
    }
  }

  send(due: Due | null): void {
    if (due === null) return;
    if (due.commands.length > 0) {
      // The display may hold one of these commands as waiting, so that is shown first.
      this.#parts.display.flush();
      due.connection.send(...due.commands.map((each) => commandFrame(each, due.now)));
    }
    this.#parts.sent(due.commands.map(({ record }) => record));
  }

  /** Sends what is due. Shows the page a new command that is not part of it. */
  sendOrShow(added: TermedRecord, due: Due | null): void {
    this.send(due);
    const isSent = due?.commands.some(({ record }) => record.seq === added.record.seq) === true;
    if (!isSent) this.#parts.display.show([added]);
  }
}

/** The message that delivers a command, with the time left to start it. */
export function commandFrame(
  { record, driver, ttl, deadline, replace, lease }: TermedRecord,
  now: number,
): RelayToPage {
  const { seq, key, command, acceptedAt } = record;
  const type = command.action === "stop" ? "stop" : "command";
  // If the clock was set back, the command must not gain time.
  const remaining = Math.min(ttl, Math.max(0, deadline - now));
  const name = keyId(driver);
  const terms = { driver: name, ttl, remaining, replace, lease };
  return { type, at: now, seq, key, command, acceptedAt, ...terms };
}

/**
 * Shows the page commands that it does not have: those that wait, and those that ended without it.
 * The display is for people. It is immediate at low rates, and batched once a second at high rates.
 */
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
    this.#showWhenDue(page.connection);
  }

  /** Sends a message to the page, after the held commands. */
  sendWith(message: RelayToPage): void {
    const page = this.#page();
    if (page !== null) this.#send(page.connection, message);
  }

  /** Shows the held commands. Callers flush before the page receives one of them. */
  flush(): void {
    const page = this.#page();
    if (page !== null && this.#held.length > 0) this.#send(page.connection);
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

  #showWhenDue(connection: PageConnection): void {
    if (this.#held.length === 0) return;
    const waitMs = this.#shownAt + limits.shownIntervalMs - this.#clock.now();
    if (waitMs <= 0) return this.#send(connection);
    if (this.#isArmed) return;
    this.#isArmed = true;
    this.#timers.wakeAfter(waitMs, this);
  }

  #send(connection: PageConnection, ...more: RelayToPage[]): void {
    const shown = this.#held.map(({ record, ttl }): RelayToPage => ({
      type: "state",
      record,
      ttl,
    }));
    if (shown.length > 0) this.#shownAt = this.#clock.now();
    this.#held = [];
    connection.send(...shown, ...more);
  }
}
