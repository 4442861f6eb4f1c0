/**
 * Delivers commands to the robot's page in order. Commands are marked as delivered before they are
 * sent. The page is shown the commands that it may not have yet.
 */
import { closeReasons, type CommandRecord, type RelayToPage } from "@corridor/protocol";
import { deliverStep } from "../../commands/state-machine.ts";
import { keyId } from "../../platform/keys.ts";
import type { Clock } from "../../platform/time/clock.ts";
import type { RobotStore, TermedRecord } from "../../store/port.ts";
import { limits } from "../../platform/limits/limits.ts";
import type { PageDisplay } from "../page/page-display.ts";
import type { PageLink, PageOwnership } from "../page/page-ownership.ts";

/** Commands that are marked as delivered and are to be sent now. */
export interface Due {
  link: PageLink;
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
    const { link, epoch } = page;
    const now = clock.now();
    try {
      // After most commands there is nothing more to deliver, which needs no query to detect.
      if (store.current(robot)?.hasAll(limits.deliveredWindow) === true) return null;
      return {
        link,
        commands: await store.commit(robot, deliverStep(epoch, limits.deliveredWindow, now)),
        now,
      };
    } catch {
      // The commands stay stored. The page reconnects after this close code and receives them then.
      link.close(closeReasons.busy);
      return null;
    }
  }

  send(due: Due | null): void {
    if (due === null) return;
    if (due.commands.length > 0) {
      // The display may hold one of these commands as waiting, so that is shown first.
      this.#parts.display.flush();
      due.link.send(...due.commands.map((each) => commandFrame(each, due.now)));
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
