import { EVENT_RETENTION_MS, MAX_STORED_EVENTS, type CommandRecord } from "@corridor/protocol";
import fc from "fast-check";
import { expect, it } from "vitest";
import type { Clock } from "../../platform/time/clock.ts";
import { EventLog } from "../../platform/events/event-log.ts";
import { recordPacking } from "./packed-record.ts";

/** Every field has a different value, and most differ for each seq. */
const record = (seq: number): CommandRecord => ({
  seq,
  key: seq % 2 === 0 ? null : `key-of-${seq}`,
  action: "move",
  command: { action: "move", distance: seq },
  state: seq % 3 === 0 ? "accepted" : "collided",
  reason: seq % 5 === 0 ? null : `It met wall ${seq}, »hard« 🧱.`,
  acceptedAt: "2026-01-01T00:00:00.000Z",
  pose: seq % 7 === 0 ? null : { x: seq, y: 0.5, heading: 90 },
  distance: seq % 11 === 0 ? null : seq + 0.25,
  duplicate: seq % 13 === 0,
});

const step = fc.oneof(
  { weight: 4, arbitrary: fc.record({ add: fc.integer({ min: 1, max: 400 }) }) },
  fc.record({ passMs: fc.integer({ min: 1, max: EVENT_RETENTION_MS }) }),
  fc.constant("delete" as const),
  fc.constant("lose" as const),
);

it("returns each event within the limits of age and count by its number, and reports missing ones", () => {
  fc.assert(
    fc.property(fc.array(step, { maxLength: 20 }), (steps) => {
      let now = 0;
      const clock: Clock = { now: () => now, after: () => () => undefined };
      const log = new EventLog(clock, recordPacking);
      let n = 0;
      let stored: { n: number; at: number }[] = [];
      for (const each of steps) {
        if (each === "delete") {
          log.deleteOld();
          stored = stored.filter(({ at }) => at >= now - EVENT_RETENTION_MS);
        } else if (each === "lose") {
          log.lose();
          n += 1;
          stored = [];
        } else if ("passMs" in each) now += each.passMs;
        else {
          for (let times = 0; times < each.add; times++) {
            n += 1;
            log.add(record(n));
            stored = [...stored, { n, at: now }].slice(-MAX_STORED_EVENTS);
          }
        }
        const oldest = stored[0]?.n ?? n + 1;
        expect(log.n).toBe(n);
        expect(log.after(n + 1)).toBeNull();
        expect([...(log.after(n) ?? [null])]).toEqual([]);
        expect(log.after(oldest - 2)).toBeNull();
        expect([...(log.after(oldest - 1) ?? [])]).toEqual(
          stored.map((one) => ({ n: one.n, record: record(one.n) })),
        );
        expect(log.numberOf(log.since)).toBe(n);
      }
    }),
    { numRuns: 50 },
  );
});

it("returns no event under another event's number, even if it changes during a read", () => {
  const clock: Clock = { now: () => 0, after: () => () => undefined };
  for (const happens of ["add", "lose"] as const) {
    const log = new EventLog(clock, recordPacking);
    for (let n = 1; n <= MAX_STORED_EVENTS; n++) log.add(record(n));
    const sent: number[] = [];
    for (const event of log.after(0) ?? []) {
      expect(event.record).toEqual(record(event.n));
      sent.push(event.n);
      if (event.n === 500 && happens === "lose") log.lose();
      else if (event.n > 500) log.add(record(log.n + 1));
    }
    const last = happens === "lose" ? 500 : MAX_STORED_EVENTS;
    expect(sent).toEqual(Array.from({ length: last }, (_, at) => at + 1));
  }
});

it("stores fewer events if they are long", () => {
  const clock: Clock = { now: () => 0, after: () => () => undefined };
  const log = new EventLog(clock, recordPacking);
  const until = Array.from({ length: 200 }, () => ({
    sensor: "front" as const,
    is: "<=" as const,
    than: 60,
  }));
  for (let n = 1; n <= MAX_STORED_EVENTS; n++) {
    log.add({ ...record(n), action: "forward", command: { action: "forward", until } });
  }
  expect(log.hasAfter(MAX_STORED_EVENTS - 200)).toBe(true);
  expect(log.hasAfter(0)).toBe(false);
});
