/** Events for a request that waits: what a feed tells a reader that stays, in one answer. */
import type { EventGap, EventPage } from "@corridor/protocol";
import type { Audience, Patience } from "./audience.ts";
import type { ReaderSource } from "./reader-feed.ts";

export interface WantedEvents {
  /** the last state that is known; undefined: how things stand now */
  since?: string | undefined;
  /** seq of the newest snapshot that is known; undefined: no snapshot is waited for */
  after?: number | undefined;
}

/**
 * Waits until there is a state after `since` or a snapshot newer than `after`, or the robot goes.
 * @returns what there is then; at once when states were missed, or when it is the first request
 */
export async function nextEvents(
  source: ReaderSource & { audience: Audience },
  { since, after }: WantedEvents,
  patience: Patience,
): Promise<EventPage> {
  const { events, audience } = source;
  const page = (told: number, gap: EventGap | null): EventPage => ({
    since: events.since,
    gap,
    states: [...(events.after(told) ?? [])],
    snapshot: source.newest()?.value ?? null,
  });
  if (since === undefined) return page(events.n, null);
  const told = events.numberOf(since);
  if (told === null || !events.hasAfter(told)) return afterGap(source, page);
  const before = source.newest();
  const isKnown = after === undefined || (before?.seq ?? -1) <= after;
  if (events.n === told && isKnown) {
    await audience.until(patience, (done) => ({
      state: done,
      ...(after !== undefined && {
        snapshot: ({ seq, state }) => {
          if (seq > after || state !== before?.state) done();
        },
      }),
    }));
  }
  // A burst while this waited may have been more than is kept.
  return events.hasAfter(told) ? page(told, null) : afterGap(source, page);
}

async function afterGap(
  source: ReaderSource,
  page: (told: number, gap: EventGap) => EventPage,
): Promise<EventPage> {
  const { promise, resolve } = Promise.withResolvers<EventPage>();
  await source.tellOpen((open) => {
    const { n } = source.events;
    resolve(page(n, { n, open }));
  });
  return promise;
}
