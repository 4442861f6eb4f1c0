import { describe, expect, it } from "vitest";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";
import { LessonsStorage } from "./lessons-storage.ts";

const KEY = "corridor.lessons";

describe("what the device remembers of the lessons", () => {
  it("is there again after a reload", () => {
    const device = new MemoryStorage();
    const before = new LessonsStorage(device);
    expect(before.isKnown).toBe(false);
    before.add({ works: { "one-line": "w1" }, home: "w0" });
    before.add({ done: { "one-line": { lines: 1, ticks: 420 } } });
    before.storeChallenge("w9", "{}");
    const after = new LessonsStorage(device);
    expect(after.isKnown).toBe(true);
    expect(after.record).toEqual({
      done: { "one-line": { lines: 1, ticks: 420 } },
      works: { "one-line": "w1" },
      best: {},
      home: "w0",
    });
    expect(after.missionOf("w1")).toBe("one-line");
    expect(after.missionOf("w2")).toBeNull();
    expect(after.challengeOf("w9")).toBe("{}");
    after.deleteChallenge("w9");
    expect(new LessonsStorage(device).challengeOf("w9")).toBeNull();
  });

  it("stores what two tabs add in turn, and the better of two results", () => {
    const device = new MemoryStorage();
    const a = new LessonsStorage(device);
    const b = new LessonsStorage(device);
    a.add({ done: { one: { lines: 1, ticks: 300 } }, works: { one: "w1" } });
    b.add({ done: { two: { lines: 2, ticks: 200 } }, works: { two: "w2" } });
    a.add({ done: { three: { lines: 0, ticks: 100 }, two: { lines: 3, ticks: 100 } } });
    const all = {
      done: {
        one: { lines: 1, ticks: 300 },
        two: { lines: 2, ticks: 200 },
        three: { lines: 0, ticks: 100 },
      },
      works: { one: "w1", two: "w2" },
      best: {},
      home: null,
    };
    expect(a.record).toEqual(all);
    expect(b.record).toEqual(all);
    expect(b.record).toBe(b.record);
    expect(new LessonsStorage(device).record).toEqual(all);
    b.add({ done: { two: { lines: 2, ticks: 199 } } });
    expect(a.record.done["two"]).toEqual({ lines: 2, ticks: 199 });
  });

  it("stores the better result of a bonus mission, number by number", () => {
    const device = new MemoryStorage();
    const a = new LessonsStorage(device);
    a.add({ best: { "fewest-bumps": [2, 900] } });
    new LessonsStorage(device).add({ best: { "fewest-bumps": [1, 2000], "all-mazes": [0, 500] } });
    a.add({ best: { "fewest-bumps": [1, 2500], "all-mazes": [1, 1] } });
    expect(a.record.best).toEqual({ "fewest-bumps": [1, 2000], "all-mazes": [0, 500] });
    a.deleteProgress();
    expect(a.record.best).toEqual({});
  });

  it("deletes progress and attempts in both tabs", () => {
    const device = new MemoryStorage();
    const a = new LessonsStorage(device);
    const b = new LessonsStorage(device);
    a.add({ done: { one: { lines: 1, ticks: 300 } }, works: { one: "w1", two: "w2" } });
    b.deleteProgress();
    b.removeAttempt("w1");
    a.add({ home: "w0" });
    expect(a.record).toEqual({ done: {}, works: { two: "w2" }, best: {}, home: "w0" });
    expect(a.missionOf("w1")).toBeNull();
  });

  it.each(["no JSON", "null", "[]", '{"done":3,"works":null}', '{"done":{"a":{"lines":"x"}}}'])(
    "that cannot be read counts as nothing: %s",
    (text) => {
      const device = new MemoryStorage();
      device.setItem(KEY, text);
      expect(new LessonsStorage(device).record).toEqual({
        done: {},
        works: {},
        best: {},
        home: null,
      });
    },
  );

  it("lasts as long as the page if the device is full, and reports it", () => {
    const device = new MemoryStorage();
    device.isFull = true;
    const storage = new LessonsStorage(device);
    expect(storage.add({ home: "w0" })).toBe(false);
    expect(storage.storeChallenge("w1", "{}")).toBe(false);
    expect(storage.add({ done: { one: { lines: 1, ticks: 300 } } })).toBe(false);
    expect(storage.record.home).toBe("w0");
    expect(storage.challengeOf("w1")).toBe("{}");
    device.isFull = false;
    new LessonsStorage(device).add({ done: { two: { lines: 1, ticks: 300 } } });
    expect(storage.add({ works: { one: "w1" } })).toBe(true);
    expect(Object.keys(storage.record.done)).toEqual(["two", "one"]);
    expect(new LessonsStorage(device).record).toEqual(storage.record);
  });

  it("deletes progress even if the device is full", () => {
    const device = new MemoryStorage();
    const storage = new LessonsStorage(device);
    storage.add({ done: { one: { lines: 1, ticks: 300 } } });
    device.isFull = true;
    storage.deleteProgress();
    expect(storage.record.done).toEqual({});
  });
});
