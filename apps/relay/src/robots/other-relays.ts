/** Handles the messages of other relays for one robot. */
import { closeReasons } from "@corridor/protocol";
import type { Clock } from "../platform/time/clock.ts";
import type { BusMessage } from "../bus/bus.ts";
import type { CarriedSnapshot } from "../bus/carried-snapshot.ts";
import type { CommandLife } from "./delivery/command-life.ts";
import type { Presence } from "./presence/presence.ts";
import type { KeyRing } from "./access/key-ring.ts";
import { limits } from "../platform/limits/limits.ts";
import type { MazeBoard } from "./maze-board.ts";
import type { PageLink, PageOwnership } from "./page/page-ownership.ts";
import type { RobotChannel } from "./presence/robot-channel.ts";
import type { RobotView } from "./robot-view.ts";

export interface OtherRelaysParts {
  clock: Clock;
  ownership: PageOwnership;
  view: RobotView;
  channel: RobotChannel;
  life: CommandLife;
  keys: KeyRing;
  mazes: MazeBoard;
  presence: Presence;
  /** other relays consider the page at this relay disconnected */
  lapsed(link: PageLink): void;
  /** readers must receive a new snapshot */
  notifyReaders(): void;
  /** the page must receive the changed scripts */
  notifyScripts(): void;
  /** another relay has deleted the robot */
  over(): void;
}

export class OtherRelays {
  readonly #parts: OtherRelaysParts;
  /** ends the wait for the page's relay */
  #met: () => void = () => undefined;

  constructor(parts: OtherRelaysParts) {
    this.#parts = parts;
  }

  /**
   * If another relay has the page, waits for its response: the newest snapshot, if there is one.
   */
  async meet(): Promise<void> {
    const { ownership, channel, presence, clock } = this.#parts;
    if (!ownership.isElsewhere) return;
    const { promise, resolve } = Promise.withResolvers<void>();
    this.#met = resolve;
    channel.announce(presence.report(), true);
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
    life.missedSteps();
    keys.refresh();
    // If the store is unavailable, readers still receive the next change of the maze.
    mazes.reload().catch(() => undefined);
  }

  received(message: BusMessage): void {
    const { ownership, view, channel, life, keys, mazes, presence, clock } = this.#parts;
    const { page } = ownership;
    switch (message.kind) {
      case "page":
        ownership.acquireElsewhere(message.epoch, message.name)?.link.close(closeReasons.replaced);
        return channel.announce(presence.report());
      case "page-left":
        if (!ownership.leaveElsewhere(message.epoch, clock.now(), message.closedByPage)) return;
        life.handover.left(message.epoch, message.closedByPage);
        view.pageLeft();
        return this.#parts.notifyReaders();
      case "yield":
        life.handover.ask(message.epoch);
        return;
      case "yielded":
        return life.handover.yielded(message.epoch, false);
      case "lapsed":
        if (page !== null) this.#parts.lapsed(page.link);
        return;
      case "snapshot":
        if (page !== null) return;
        view.receive(message.snapshot);
        this.#met();
        return this.#parts.notifyReaders();
      case "here":
        channel.receivedAnnouncement(message.from, message.scripts);
        if (page === null) return this.#met();
        if (message.asks) this.#answer(view.newest);
        return this.#parts.notifyScripts();
      case "cancel":
        return page?.link.send({ type: "cancel", seq: message.seq, cause: message.cause });
      case "keys":
        return keys.refresh();
      case "maze":
        return mazes.received(message.version);
      case "over":
        return this.#parts.over();
    }
  }

  #answer(newest: CarriedSnapshot | null): void {
    const { channel, presence } = this.#parts;
    if (newest === null) channel.announce(presence.report());
    else channel.snapshot(newest);
  }
}
