/** The page side of one robot: pages acquire and leave the robot, and report what it does. */
import { closeReasons, type PageToRelay, type Resume } from "@corridor/protocol";
import type { Clock } from "../platform/time/clock.ts";
import { CarriedSnapshot } from "../bus/carried-snapshot.ts";
import type { CommandLife } from "./delivery/command-life.ts";
import type { LiveView } from "./live-view.ts";
import type { PageConnection, PageOwnership } from "./page/page-ownership.ts";
import type { RobotChannel } from "./channel/robot-channel.ts";
import type { RobotUse } from "./robot-use.ts";
import type { ScriptReport } from "./script-report.ts";

export interface RobotPageParts {
  /** when the robot was created */
  createdAt: number;
  clock: Clock;
  ownership: PageOwnership;
  life: Pick<CommandLife, "acquirePage" | "receiveFromPage" | "handover">;
  view: LiveView;
  channel: Pick<RobotChannel, "pageLeft" | "flush">;
  use: Pick<RobotUse, "used">;
  report: Pick<ScriptReport, "send">;
}

export class RobotPage {
  readonly #parts: RobotPageParts;

  constructor(parts: RobotPageParts) {
    this.#parts = parts;
  }

  /** A page acquires the robot. The previous page is disconnected. */
  async acquire(connection: PageConnection, resume: Resume): Promise<void> {
    const { createdAt, clock, ownership, life, view, use, report } = this.#parts;
    await life.acquirePage(connection, resume, () => {
      use.used();
      view.pageConnected(ownership.epoch > 1 ? clock.now() - createdAt : 0);
      // Before the endings in the same message, so that readers of an ending see no older snapshot.
      if (resume.snapshot !== undefined) view.report(CarriedSnapshot.of(resume.snapshot));
      report.send();
      // The page disconnected before it owned the robot, when `leave` had no effect yet.
      if (!connection.isOpen) this.leave(connection, false);
    });
  }

  /**
   * The page's connection is closed. No effect if another page owns the robot.
   * @param closedByPage whether the page closed it, after all of its reports
   */
  leave(connection: PageConnection, closedByPage: boolean): void {
    const { clock, ownership, life, view, channel } = this.#parts;
    if (!ownership.isHeldBy(connection)) return;
    ownership.leave(clock.now(), closedByPage);
    life.handover.left(ownership.epoch, closedByPage);
    view.pageLeft();
    channel.pageLeft(ownership.epoch, closedByPage);
  }

  /** Disconnects the page, because other relays consider it disconnected. */
  lapsed(): void {
    const { page } = this.#parts.ownership;
    if (page === null) return;
    page.connection.close(closeReasons.restart);
    this.leave(page.connection, false);
  }

  /**
   * Handles a snapshot of the page. The check of the page's permission already recorded the use.
   */
  receiveSnapshot(connection: PageConnection, epoch: number, snapshot: CarriedSnapshot): void {
    if (this.#isCurrent(connection, epoch)) this.#parts.view.report(snapshot);
  }

  /**
   * Handles a message of the page. Ignores messages of a replaced page. Disconnects a page that
   * sends another epoch.
   */
  receive(connection: PageConnection, message: PageToRelay): Promise<void> | undefined {
    const { clock, life, view, channel, use } = this.#parts;
    if (!this.#isCurrent(connection, message.epoch)) return undefined;
    use.used();
    switch (message.type) {
      case "snapshot":
        view.report(CarriedSnapshot.of(message.snapshot));
        return undefined;
      case "time":
        connection.send({ type: "time", at: clock.now() });
        return undefined;
      case "ended":
        channel.flush();
        return life.receiveFromPage(connection, message);
      case "started":
      case "yielded":
        return life.receiveFromPage(connection, message);
    }
  }

  /**
   * Whether the page owns the robot with this epoch. Disconnects a page that sends another epoch.
   */
  #isCurrent(connection: PageConnection, epoch: number): boolean {
    const { ownership } = this.#parts;
    if (!ownership.isHeldBy(connection)) return false;
    if (epoch !== ownership.page?.epoch) {
      connection.close(closeReasons.replaced);
      return false;
    }
    return true;
  }
}
