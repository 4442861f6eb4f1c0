/**
 * In-process message bus of a single relay. In tests, several relays of one process share one bus
 * and form a cluster.
 */
import type { Ears, Line, News, Step, Switchboard } from "./bus.ts";

interface Member {
  ears: Ears;
  /** the page that it owns, or null */
  page: Extract<News, { kind: "page" }> | null;
}

export class LocalSwitchboard implements Switchboard {
  readonly #lines = new Map<string, Set<Member>>();

  async join(robot: string, ears: Ears): Promise<Line> {
    const members = this.#lines.get(robot) ?? new Set();
    this.#lines.set(robot, members);
    for (const { page } of members) if (page !== null) ears.heard(page);
    const member: Member = { ears, page: null };
    members.add(member);
    const tell = (news: News): void => {
      for (const other of members) if (other !== member) other.ears.heard(news);
    };
    const leftPage = (saidGoodbye: boolean): void => {
      const { page: left } = member;
      member.page = null;
      if (left !== null) tell({ kind: "page-left", epoch: left.epoch, saidGoodbye });
    };
    return {
      stepped: (step: Step) => {
        // The relay's own readers need the changed states. Only other relays need the added
        // command.
        if (step.changed.length === 0 && (step.added === null || members.size === 1)) return;
        for (const other of members) other.ears.stepped(step, other === member);
      },
      tell: (news) => {
        if (news.kind === "page-left") return leftPage(news.saidGoodbye);
        if (news.kind === "page") member.page = news;
        return tell(news);
      },
      hurry: () => undefined,
      leave: () => {
        members.delete(member);
        leftPage(false);
        if (members.size === 0 && this.#lines.get(robot) === members) this.#lines.delete(robot);
      },
    };
  }

  async close(): Promise<void> {
    this.#lines.clear();
  }
}
