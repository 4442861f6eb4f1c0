import { expect, it } from "vitest";
import { AdaptiveJournal, type Journal, type Entry } from "./journal.ts";

function withWays() {
  let time = 0;
  const disk = { ms: 0.3 };
  const writes: string[] = [];
  const way = (name: string): Journal => ({
    write: (entries, compaction, written) => {
      writes.push(`${name} ${entries.length}${compaction === null ? "" : " compaction"}`);
      time += disk.ms;
      written(null, null);
    },
    close: async () => void writes.push(`${name} closed`),
  });
  const shorter = new AdaptiveJournal(way("own"), way("thread"), () => time);
  const write = (count: number, isCompacting = false): string | undefined => {
    const entries = Array.from({ length: count }, (_, n): Entry => [n, "robot", "{}"]);
    const compaction = isCompacting ? { bringing: [], deleted: 1, stored: [] } : null;
    let isReported = false;
    shorter.write(entries, compaction, () => (isReported = true));
    expect(isReported).toBe(true);
    return writes.at(-1);
  };
  return { write, disk, writes, shorter, pass: (ms: number) => (time += ms) };
}

it("writes few entries itself, and lets the thread write many entries and compactions", async () => {
  const { write, shorter, writes } = withWays();
  expect([write(1), write(4), write(1, true), write(1), write(5)]).toEqual([
    "own 1",
    "own 4",
    "thread 1 compaction",
    "own 1",
    "thread 5",
  ]);
  await shorter.close();
  expect(writes.at(-1)).toBe("thread closed");
});

it("lets the thread write few entries right after many, because more will follow", () => {
  const { write } = withWays();
  expect([write(9), write(1), write(1)]).toEqual(["thread 9", "thread 1", "own 1"]);
});

it("writes three entries itself on a slow disk, then one every ten seconds until the disk is fast", () => {
  const { write, disk, pass } = withWays();
  disk.ms = 8;
  expect([write(1), write(1), write(1), write(1)]).toEqual(["own 1", "own 1", "own 1", "thread 1"]);
  pass(9_000);
  expect(write(1)).toBe("thread 1");
  pass(1_000);
  expect([write(1), write(1)]).toEqual(["own 1", "thread 1"]);
  disk.ms = 0.3;
  pass(10_000);
  expect([write(1), write(1), write(1)]).toEqual(["own 1", "own 1", "own 1"]);
});

it.each([
  { times: [8, 0.3, 8, 0.3, 8, 0.3, 8, 0.3], last: "own 1", how: "now and then" },
  { times: [8, 8, 0.3, 8, 8, 0.3], last: "thread 1", how: "more often than not" },
])("judges a disk that is slow $how by its recent writes", ({ times, last }) => {
  const { write, disk } = withWays();
  for (const ms of times) {
    disk.ms = ms;
    write(1);
  }
  expect(write(1)).toBe(last);
});
