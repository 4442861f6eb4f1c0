import { describe, expect, it } from "vitest";
import { settle, standingOf, type JudgedStudent, type Standing } from "./standing.ts";

const MINUTE = 60_000;
const NOW = 20 * MINUTE;

const tile = { task: 1, state: "writing", line: null } as const;
const working: JudgedStudent["student"] = {
  helpSince: null,
  isConnected: true,
  tile,
  busyAt: NOW,
  bestAt: NOW,
  repeats: 0,
};

function judged(change: Partial<JudgedStudent["student"]>, isSolved = false) {
  return standingOf({ student: { ...working, ...change }, task: 1, isSolved }, NOW, NOW - MINUTE);
}

describe("a student", () => {
  it.each<{ what: string; change: Partial<JudgedStudent["student"]>; standing: Standing }>([
    { what: "who writes", change: {}, standing: "working" },
    {
      what: "whose robot drives",
      change: { tile: { ...tile, state: "driving" } },
      standing: "working",
    },
    {
      what: "whose robot bumped",
      change: { tile: { ...tile, state: "bumped" } },
      standing: "bumped",
    },
    {
      what: "whose page claims to be solved",
      change: { tile: { ...tile, state: "solved" } },
      standing: "working",
    },
    { what: "who asked for help", change: { helpSince: 1, repeats: 9 }, standing: "help" },
    {
      what: "who asked for help and left",
      change: { helpSince: 1, isConnected: false },
      standing: "help",
    },
    {
      what: "who is not connected",
      change: { isConnected: false, repeats: 9 },
      standing: "disconnected",
    },
    { what: "with 3 equal failures", change: { repeats: 3 }, standing: "working" },
    { what: "with 4 equal failures", change: { repeats: 4 }, standing: "stuck" },
    { what: "who did nothing for 179 s", change: { busyAt: NOW - 179_000 }, standing: "working" },
    { what: "who did nothing for 180 s", change: { busyAt: NOW - 180_000 }, standing: "stuck" },
    {
      what: "without a better result for 7:59",
      change: { bestAt: NOW - 479_000 },
      standing: "working",
    },
    {
      what: "without a better result for 8:00",
      change: { bestAt: NOW - 480_000 },
      standing: "stuck",
    },
    {
      what: "who is stuck where the robot bumped",
      change: { repeats: 4, tile: { ...tile, state: "bumped" } },
      standing: "stuck",
    },
  ])("$what is: $standing", ({ change, standing }) => {
    expect(judged(change).standing).toBe(standing);
  });

  it("who has solved the task is never stuck, however long ago", () => {
    const change = { bestAt: NOW - 10 * MINUTE, busyAt: NOW - 10 * MINUTE, repeats: 9 };
    expect(judged(change, true)).toMatchObject({ standing: "solved", since: NOW - 10 * MINUTE });
    expect(judged({ ...change, isConnected: false }, true).standing).toBe("solved");
  });

  it("is stuck since the first rule applied", () => {
    const change = { busyAt: NOW - 4 * MINUTE, bestAt: NOW - 9 * MINUTE };
    expect(judged(change).since).toBe(NOW - MINUTE);
  });
});

describe("what a card shows", () => {
  const shown = (standing: Standing) => ({ standing, since: 0, task: 1, shownAt: 0 });

  it.each<{ before: Standing; next: Standing; afterMs: number; expected: Standing }>([
    { before: "working", next: "bumped", afterMs: 0, expected: "bumped" },
    { before: "bumped", next: "stuck", afterMs: 0, expected: "stuck" },
    { before: "stuck", next: "help", afterMs: 0, expected: "help" },
    { before: "bumped", next: "working", afterMs: 19_999, expected: "bumped" },
    { before: "bumped", next: "working", afterMs: 20_000, expected: "working" },
    { before: "stuck", next: "working", afterMs: 19_999, expected: "stuck" },
    { before: "help", next: "working", afterMs: 19_999, expected: "help" },
    { before: "working", next: "disconnected", afterMs: 19_999, expected: "working" },
    { before: "working", next: "disconnected", afterMs: 20_000, expected: "disconnected" },
    { before: "stuck", next: "solved", afterMs: 0, expected: "solved" },
  ])("is $expected $afterMs ms after $before turned into $next", (row) => {
    const next = { standing: row.next, since: 5, task: 1 };
    expect(settle(shown(row.before), next, row.afterMs).standing).toBe(row.expected);
  });

  it("begins with the first standing", () => {
    const next = { standing: "stuck", since: 5, task: 1 } as const;
    expect(settle(null, next, 70)).toEqual({ ...next, shownAt: 70 });
  });

  it("is about the open task: a bump in the task before does not stay", () => {
    const next = { standing: "working", since: 5, task: 2 } as const;
    expect(settle(shown("bumped"), next, 1)).toEqual({ ...next, shownAt: 1 });
  });
});
