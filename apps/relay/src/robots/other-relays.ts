/** Handles the messages of other relays for one robot. */
import { closeReasons } from "@corridor/protocol";
import type { Clock } from "../platform/time/clock.ts";
import type { BusMessage } from "../bus/bus.ts";
import type { CommandLife } from "./delivery/command-life.ts";
import type { KeyRing } from "./access/key-ring.ts";
import { limits } from "../platform/limits/limits.ts";
import type { LiveView } from "./live-view.ts";
import type { MarkBoard } from "./mark-board.ts";
import type { MazeBoard } from "./maze-board.ts";
import type { PageOwnership } from "./page/page-ownership.ts";
import type { RobotChannel } from "./channel/robot-channel.ts";
import type { RobotPage } from "./robot-page.ts";
import type { ScriptReport } from "./script-report.ts";

export interface OtherRelaysParts {
  clock: Clock;
  ownership: PageOwnership;
  view: LiveView;
  channel: RobotChannel;
  life: Pick<CommandLife, "handover" | "missedChanges">;
  keys: Pick<KeyRing, "refresh">;
  mazes: Pick<MazeBoard, "received" | "reload">;
  marks: Pick<MarkBoard, "received">;
  page: Pick<RobotPage, "lapsed">;
  report: ScriptReport;
  /** a relay has deleted the robot, maybe this one */
  over(): void;
}

export class OtherRelays {
  readonly #parts: OtherRelaysParts;
  /** ends the wait for the page's relay */
  #pageFound: () => void = () => undefined;

  constructor(parts: OtherRelaysParts) {
    this.#parts = parts;
  }

  /**
   * If another relay has the page, waits for its response: the newest snapshot, if there is one.
   */
  async waitForPage(): Promise<void> {
    const { ownership, report, clock } = this.#parts;
    if (!ownership.isElsewhere) return;
    const { promise, resolve } = Promise.withResolvers<void>();
    this.#pageFound = resolve;
    report.announce(true);
    const cancelTimer = clock.after(limits.firstSnapshotWaitMs, resolve);
    await promise;
    cancelTimer();
  }

  /**
   * Messages may have been missed: notifies readers, delivers waiting commands, reads keys and
   * maze.
   */
  missed(): void {
    const { life, keys, mazes } = this.#parts;
    life.missedChanges();
    keys.refresh();
    // If the store is unavailable, readers still receive the next change of the maze.
    mazes.reload().catch(() => undefined);
  }

  received(message: BusMessage): void {
    const { ownership, view, channel, life, keys, mazes, marks, report, clock } = this.#parts;
    const { page } = ownership;
    switch (message.kind) {
      case "page":
        ownership
          .acquireElsewhere(message.epoch, message.name)
          ?.connection.close(closeReasons.replaced);
        return report.announce();
      case "page-left":
        if (!ownership.leaveElsewhere(message.epoch, clock.now(), message.closedByPage)) return;
        life.handover.left(message.epoch, message.closedByPage);
        return view.pageLeftElsewhere();
      case "yield":
        life.handover.ask(message.epoch);
        return;
      case "yielded":
        return life.handover.yielded(message.epoch, false);
      case "lapsed":
        return this.#parts.page.lapsed();
      case "snapshot":
        if (page !== null) return;
        view.receive(message.snapshot);
        return this.#pageFound();
      case "here":
        channel.receivedAnnouncement(message.from, message.scripts);
        if (page === null) return this.#pageFound();
        if (message.asks) this.#answer();
        return report.send();
      case "cancel":
        return page?.connection.send({ type: "cancel", seq: message.seq, cause: message.cause });
      case "keys":
        return keys.refresh();
      case "maze":
        return mazes.received(message.version);
      case "marks":
        return marks.received(message.marks);
      case "over":
        return this.#parts.over();
    }
  }

  /** Sends the newest snapshot, or reports that there is none. */
  #answer(): void {
    const { channel, view, report } = this.#parts;
    if (view.newest === null) report.announce();
    else channel.snapshot(view.newest);
  }
}
