/** The connection between page, relay and reader. */
export interface NetworkPath {
  /** ms between two reports of the page; a list repeats */
  pageMs: number | readonly number[];
  /** round trip in ms at a time */
  roundTripMs: (now: number) => number;
  /** additional delay of the next message in ms; messages stay in order */
  jitterMs?: () => number;
}

export interface Acknowledger {
  reset(): void;
  read(now: number): boolean;
}

export interface ReadingLog {
  /** times at which a snapshot was read */
  read: number[];
  /** times at which a snapshot was acknowledged */
  acknowledged: number[];
}

/** Unacknowledged snapshots, as in the relay. */
const CREDIT = 2;
const INTERVAL_MS = 50;
/** Resolution of the relay's timers; their lateness does not accumulate. */
const TIMER_MS = 5;

/**
 * Simulates, in virtual time, a page that reports, a relay that sends at most 20 snapshots a second
 * and two unacknowledged ones, and a reader that acknowledges them.
 */
export function simulateReading(
  path: NetworkPath,
  reader: Acknowledger,
  untilMs: number,
): ReadingLog {
  const { pageMs, roundTripMs, jitterMs = () => 0 } = path;
  const log: ReadingLog = { read: [], acknowledged: [] };
  const due: { at: number; order: number; call: () => void }[] = [];
  let order = 0;
  const arrivals = { down: 0, up: 0 };
  let now = 0;
  const at = (time: number, call: () => void): void => {
    const next = { at: time, order: order++, call };
    const before = due.findIndex((each) => each.at > time);
    due.splice(before === -1 ? due.length : before, 0, next);
  };
  const transmit = (direction: "down" | "up", call: () => void): void => {
    arrivals[direction] = Math.max(arrivals[direction], now + roundTripMs(now) / 2 + jitterMs());
    at(arrivals[direction], call);
  };

  let seq = 0;
  let pending: number | null = null;
  let unacknowledged: number[] = [];
  let notBefore = 0;
  let isScheduled = false;
  const schedule = (ms: number): void => {
    if (isScheduled) return;
    isScheduled = true;
    at(Math.ceil((now + ms) / TIMER_MS) * TIMER_MS, () => {
      isScheduled = false;
      flush();
    });
  };
  const flush = (): void => {
    if (pending === null) return;
    if (now < notBefore) return schedule(notBefore - now);
    if (unacknowledged.length >= CREDIT) return schedule(INTERVAL_MS);
    const sent = pending;
    pending = null;
    notBefore = Math.min(now, Math.max(notBefore, now - TIMER_MS)) + INTERVAL_MS;
    unacknowledged.push(sent);
    transmit("down", () => {
      log.read.push(now);
      if (!reader.read(now)) return;
      log.acknowledged.push(now);
      transmit("up", () => {
        unacknowledged = unacknowledged.filter((each) => each > sent);
        if (now >= notBefore) flush();
      });
    });
  };
  const intervals = typeof pageMs === "number" ? [pageMs] : pageMs;
  const report = (reportedAt: number): void => {
    pending = ++seq;
    if (!isScheduled) flush();
    const nextAt = reportedAt + (intervals[seq % intervals.length] ?? 0);
    at(nextAt, () => report(nextAt));
  };
  reader.reset();
  report(0);
  for (let next = due.shift(); next !== undefined && next.at < untilMs; next = due.shift()) {
    now = next.at;
    next.call();
  }
  return log;
}
