import { expect, it } from "vitest";
import type { Journal } from "./journal.ts";
import type { Entry } from "./journal-writer.ts";
import { AdaptiveJournal } from "./adaptive-journal.ts";

function withWays() {
  let time = 0;
  const disk = { ms: 0.3 };
  const written: string[] = [];
  const way = (name: string): Journal => ({
    write: (entries, tidying, told) => {
      written.push(`${name} ${entries.length}${tidying === null ? "" : " tidying"}`);
      time += disk.ms;
      told(null, null);
    },
    close: async () => void written.push(`${name} closed`),
  });
  const shorter = new AdaptiveJournal(way("own"), way("thread"), () => time);
  const write = (count: number, isTidying = false): string | undefined => {
    const entries = Array.from({ length: count }, (_, n): Entry => [n, "robot", "{}"]);
    const tidying = isTidying ? { bringing: [], deleted: 1, kept: [] } : null;
    let isTold = false;
    shorter.write(entries, tidying, () => (isTold = true));
    expect(isTold).toBe(true);
    return written.at(-1);
  };
  return { write, disk, written, shorter, pass: (ms: number) => (time += ms) };
}

it("writes few entries itself, and has many or what is tidied written by the thread", async () => {
  const { write, shorter, written } = withWays();
  expect([write(1), write(4), write(1, true), write(1), write(5)]).toEqual([
    "own 1",
    "own 4",
    "thread 1 tidying",
    "own 1",
    "thread 5",
  ]);
  await shorter.close();
  expect(written.at(-1)).toBe("thread closed");
});

it("has the thread write few, too, right behind many: more will come", () => {
  const { write } = withWays();
  expect([write(9), write(1), write(1)]).toEqual(["thread 9", "thread 1", "own 1"]);
});

it("has three wait for a slow disk, then one every ten seconds until it is quick", () => {
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
])("takes a disk that is slow $how for what it is", ({ times, last }) => {
  const { write, disk } = withWays();
  for (const ms of times) {
    disk.ms = ms;
    write(1);
  }
  expect(write(1)).toBe(last);
});
