/**
 * The lines of one relay, on which nobody else is. In tests several relays of one process share one, and
 * are a cluster.
 */
import type { Ears, Line, News, Step, Switchboard } from "./switchboard.ts";

interface Place {
  ears: Ears;
  /** the page that it has; null: it has none */
  page: Extract<News, { kind: "page" }> | null;
}

export class LocalSwitchboard implements Switchboard {
  readonly #lines = new Map<string, Set<Place>>();

  async join(robot: string, ears: Ears): Promise<Line> {
    const places = this.#lines.get(robot) ?? new Set();
    this.#lines.set(robot, places);
    for (const { page } of places) if (page !== null) ears.heard(page);
    const place: Place = { ears, page: null };
    places.add(place);
    const tell = (news: News): void => {
      for (const other of places) if (other !== place) other.ears.heard(news);
    };
    const leftPage = (saidGoodbye: boolean): void => {
      const { page: left } = place;
      place.page = null;
      if (left !== null) tell({ kind: "page-left", epoch: left.epoch, saidGoodbye });
    };
    return {
      stepped: (step: Step) => {
        // Its own readers are told of what has changed; what came is for others to know.
        if (step.changed.length === 0 && (step.added === null || places.size === 1)) return;
        for (const other of places) other.ears.stepped(step, other === place);
      },
      tell: (news) => {
        if (news.kind === "page-left") return leftPage(news.saidGoodbye);
        if (news.kind === "page") place.page = news;
        return tell(news);
      },
      hurry: () => undefined,
      leave: () => {
        places.delete(place);
        leftPage(false);
        if (places.size === 0 && this.#lines.get(robot) === places) this.#lines.delete(robot);
      },
    };
  }

  async close(): Promise<void> {
    this.#lines.clear();
  }
}
