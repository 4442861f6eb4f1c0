/**
 * A minute of snapshots over a line, in a moment: a page that reports, a relay that lets two be on their way and at most
 * 20 a second, as the real one does, and a reader that says what it has seen.
 */
export interface PacedLine {
  /** ms between two reports of the page; of several, one after the other, again and again */
  pageMs: number | readonly number[];
  /** ms there and back, at this time */
  roundTripMs: (now: number) => number;
  /** ms that the line takes longer for this message; the order stays */
  jitterMs?: () => number;
}

export interface PacedReader {
  begin(): void;
  read(now: number): boolean;
}

export interface Told {
  /** when each snapshot was read */
  read: number[];
  /** when it was said that one was seen */
  said: number[];
}

const CREDIT = 2;
const EVERY_MS = 50;
/** Its timers are shared by 5 ms; what they come late does not count. */
const SHARED_MS = 5;

export function pacedLine(line: PacedLine, reader: PacedReader, untilMs: number): Told {
  const { pageMs, roundTripMs, jitterMs = () => 0 } = line;
  const told: Told = { read: [], said: [] };
  const due: { at: number; order: number; call: () => void }[] = [];
  let order = 0;
  const arrivals = { down: 0, up: 0 };
  let now = 0;
  const at = (time: number, call: () => void): void => {
    const next = { at: time, order: order++, call };
    const before = due.findIndex((each) => each.at > time);
    due.splice(before === -1 ? due.length : before, 0, next);
  };
  const over = (way: "down" | "up", call: () => void): void => {
    arrivals[way] = Math.max(arrivals[way], now + roundTripMs(now) / 2 + jitterMs());
    at(arrivals[way], call);
  };

  let seq = 0;
  let pending: number | null = null;
  let onTheWay: number[] = [];
  let notBefore = 0;
  let isArmed = false;
  const arm = (ms: number): void => {
    if (isArmed) return;
    isArmed = true;
    at(Math.ceil((now + ms) / SHARED_MS) * SHARED_MS, () => {
      isArmed = false;
      flush();
    });
  };
  const flush = (): void => {
    if (pending === null) return;
    if (now < notBefore) return arm(notBefore - now);
    if (onTheWay.length >= CREDIT) return arm(EVERY_MS);
    const sent = pending;
    pending = null;
    notBefore = Math.min(now, Math.max(notBefore, now - SHARED_MS)) + EVERY_MS;
    onTheWay.push(sent);
    over("down", () => {
      told.read.push(now);
      if (!reader.read(now)) return;
      told.said.push(now);
      over("up", () => {
        onTheWay = onTheWay.filter((each) => each > sent);
        if (now >= notBefore) flush();
      });
    });
  };
  const pauses = typeof pageMs === "number" ? [pageMs] : pageMs;
  const report = (reportedAt: number): void => {
    pending = ++seq;
    if (!isArmed) flush();
    const nextAt = reportedAt + (pauses[seq % pauses.length] ?? 0);
    at(nextAt, () => report(nextAt));
  };
  reader.begin();
  report(0);
  for (let next = due.shift(); next !== undefined && next.at < untilMs; next = due.shift()) {
    now = next.at;
    next.call();
  }
  return told;
}
