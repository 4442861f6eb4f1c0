import { describe, expect, it } from "vitest";
import { MemoryStorage } from "../../app/testing/memory-storage.ts";
import { LessonsStorage } from "./lessons-storage.ts";

const KEY = "corridor.lessons";

describe("what the device remembers of the lessons", () => {
  it("is there again after a reload", () => {
    const device = new MemoryStorage();
    const before = new LessonsStorage(device);
    expect(before.isKnown).toBe(false);
    before.change({ works: { "one-line": "w1" }, home: "w0" });
    before.change({ done: { "one-line": { lines: 1, ticks: 420 } } });
    before.keepChallenge("w9", "{}");
    const after = new LessonsStorage(device);
    expect(after.isKnown).toBe(true);
    expect(after.record).toEqual({
      done: { "one-line": { lines: 1, ticks: 420 } },
      works: { "one-line": "w1" },
      home: "w0",
    });
    expect(after.missionOf("w1")).toBe("one-line");
    expect(after.missionOf("w2")).toBeNull();
    expect(after.challengeOf("w9")).toBe("{}");
    after.dropChallenge("w9");
    expect(new LessonsStorage(device).challengeOf("w9")).toBeNull();
  });

  it("keeps what another tab has done in the meantime", () => {
    const device = new MemoryStorage();
    const mine = new LessonsStorage(device);
    new LessonsStorage(device).change({ done: { "how-far": { lines: 0, ticks: 300 } } });
    mine.change({ home: "w0" });
    expect(Object.keys(mine.record.done)).toEqual(["how-far"]);
  });

  it.each(["no JSON", "null", "[]", '{"done":3,"works":null}', '{"done":{"a":{"lines":"x"}}}'])(
    "that cannot be read counts as nothing: %s",
    (text) => {
      const device = new MemoryStorage();
      device.setItem(KEY, text);
      expect(new LessonsStorage(device).record).toEqual({ done: {}, works: {}, home: null });
    },
  );

  it("lasts as long as the page where the device is full, and says so", () => {
    const device = new MemoryStorage();
    device.isFull = true;
    const storage = new LessonsStorage(device);
    expect(storage.change({ home: "w0" })).toBe(false);
    expect(storage.keepChallenge("w1", "{}")).toBe(false);
    expect(storage.record.home).toBe("w0");
    expect(storage.challengeOf("w1")).toBe("{}");
  });
});
