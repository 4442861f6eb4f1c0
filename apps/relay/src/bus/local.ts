/**
 * In-process message bus of a single relay. In tests, several relays of one process share one bus
 * and form a cluster.
 */
import type { BusListener, Channel, BusMessage, CommandChanges, Bus } from "./bus.ts";

interface Member {
  listener: BusListener;
  /** the page that it owns, or null */
  page: Extract<BusMessage, { kind: "page" }> | null;
}

export class LocalBus implements Bus {
  readonly #channels = new Map<string, Set<Member>>();

  async join(robot: string, listener: BusListener): Promise<Channel> {
    const members = this.#channels.get(robot) ?? new Set();
    this.#channels.set(robot, members);
    for (const { page } of members) if (page !== null) listener.received(page);
    const member: Member = { listener, page: null };
    members.add(member);
    const notify = (message: BusMessage): void => {
      for (const other of members) if (other !== member) other.listener.received(message);
    };
    const leftPage = (closedByPage: boolean): void => {
      const { page: left } = member;
      member.page = null;
      if (left !== null) notify({ kind: "page-left", epoch: left.epoch, closedByPage });
    };
    return {
      returnsOwnChanges: false,
      commandsChanged: (changes: CommandChanges) => {
        if (changes.changed.length === 0 && changes.added === null) return;
        for (const other of members)
          if (other !== member) other.listener.commandsChanged(changes, false);
      },
      notify: (message) => {
        if (message.kind === "page-left") return leftPage(message.closedByPage);
        if (message.kind === "page") member.page = message;
        return notify(message);
      },
      sendSnapshot: (snapshot) => notify({ kind: "snapshot", snapshot }),
      flush: () => undefined,
      leave: () => {
        members.delete(member);
        leftPage(false);
        if (members.size === 0 && this.#channels.get(robot) === members)
          this.#channels.delete(robot);
      },
    };
  }

  async close(): Promise<void> {
    this.#channels.clear();
  }
}
