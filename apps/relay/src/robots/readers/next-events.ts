/** Events for a long poll: what a feed sends to a connected reader, in one response. */
import type { EventGap, EventPage } from "@corridor/protocol";
import type { Subscribers, CallerWait } from "./subscribers.ts";
import type { ReaderSource } from "./feed.ts";

export interface WantedEvents {
  /** resume position; undefined: responds immediately with the current state */
  since?: string | undefined;
  /** seq of the newest known snapshot; undefined: does not wait for snapshots */
  after?: number | undefined;
}

/**
 * Waits for a state after `since`, or for a snapshot that is newer than `after` or has another
 * state.
 * @returns the events after the wait; immediately for a first request or after missed states
 */
export async function nextEvents(
  source: ReaderSource & { subscribers: Subscribers },
  { since, after }: WantedEvents,
  waitLimit: CallerWait,
): Promise<EventPage> {
  const { events, subscribers } = source;
  const page = (position: number, gap: EventGap | null): EventPage => ({
    since: events.since,
    gap,
    states: [...(events.after(position) ?? [])],
    snapshot: source.newest()?.value ?? null,
  });
  if (since === undefined) return page(events.n, null);
  const position = events.numberOf(since);
  if (position === null || !events.hasAfter(position)) return afterGap(source, page);
  const before = source.newest();
  const isKnown = after === undefined || (before?.seq ?? -1) <= after;
  if (events.n === position && isKnown) {
    await subscribers.until(waitLimit, (done) => ({
      state: done,
      ...(after !== undefined && {
        snapshot: ({ seq, state }) => {
          if (seq > after || state !== before?.state) done();
        },
      }),
    }));
  }
  // A burst during the wait may have exceeded the event log.
  return events.hasAfter(position) ? page(position, null) : afterGap(source, page);
}

async function afterGap(
  source: ReaderSource,
  page: (position: number, gap: EventGap) => EventPage,
): Promise<EventPage> {
  const { promise, resolve } = Promise.withResolvers<EventPage>();
  await source.readOpen((open) => {
    const { n } = source.events;
    resolve(page(n, { n, open }));
  });
  return promise;
}
