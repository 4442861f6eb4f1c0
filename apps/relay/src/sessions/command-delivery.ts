/**
 * Brings commands to the robot's page: what it may have next, in order, marked as delivered before it is
 * sent. What it cannot have yet it is shown.
 */
import { closeReasons, type CommandRecord } from "@corridor/protocol";
import type { Clock } from "../clock.ts";
import type { SessionStore, TermedRecord } from "../store/session-store.ts";
import { limits } from "./limits.ts";
import { commandFrame } from "./page-frames.ts";
import type { PageDisplay } from "./page-display.ts";
import type { PageHandover } from "./page-handover.ts";
import type { PageLink } from "./page-link.ts";
import type { PageSeat } from "./page-seat.ts";

/** What was marked as delivered, to be sent now. */
export interface Due {
  link: PageLink;
  commands: TermedRecord[];
  /** when it was marked */
  now: number;
}

export interface CommandDeliveryParts {
  robot: string;
  store: Pick<SessionStore, "deliver" | "hasAll">;
  clock: Clock;
  seat: PageSeat;
  handover: PageHandover;
  display: PageDisplay;
  /** is told what was sent */
  sent(records: readonly CommandRecord[]): void;
}

export class CommandDelivery {
  readonly #parts: CommandDeliveryParts;

  constructor(parts: CommandDeliveryParts) {
    this.#parts = parts;
  }

  /** Sends all that the page may have now. */
  async run(): Promise<void> {
    this.send(await this.take());
  }

  /**
   * Marks what the page may have now as delivered. Asked for in the same turn as the step before it, both
   * are one commit, and the page has a command as soon as its sender has the answer.
   * @returns what is to be sent, whatever became of that step; null: nothing, or there is no page for it
   */
  async take(): Promise<Due | null> {
    const { robot, store, clock, seat, handover } = this.#parts;
    if (seat.page === null || handover.isUnderWay) return null;
    const { link, epoch } = seat.page;
    const now = clock.now();
    try {
      // With each command that comes it is asked what the page may have now: mostly nothing more.
      if (store.hasAll(robot, limits.deliveredWindow)) return null;
      return {
        link,
        commands: await store.deliver(robot, epoch, limits.deliveredWindow, now),
        now,
      };
    } catch {
      // What is stored stays stored; the page comes back in a moment and gets it then.
      link.close(closeReasons.busy);
      return null;
    }
  }

  send(due: Due | null): void {
    if (due === null) return;
    if (due.commands.length > 0) {
      // It may have been shown one of these, as waiting.
      this.#parts.display.flush();
      due.link.send(...due.commands.map((each) => commandFrame(each, due.now)));
    }
    this.#parts.sent(due.commands.map(({ record }) => record));
  }

  /** Sends what is due, and shows the page a new command that is not among it. */
  sendOrShow(added: TermedRecord, due: Due | null): void {
    this.send(due);
    const isSent = due?.commands.some(({ record }) => record.seq === added.record.seq) === true;
    if (!isSent) this.#parts.display.show([added]);
  }
}
