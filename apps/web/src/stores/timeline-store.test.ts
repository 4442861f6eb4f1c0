import { Timeline } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import { TimelineStore } from "./timeline-store.ts";

/** A store whose time passes when the test says so, fed by a recording in the worker. */
function newStore() {
  const waiting: (() => void)[] = [];
  const recorded = new Timeline();
  const store = new TimelineStore((run) => waiting.push(run));
  const told: number[] = [];
  const end = store.listen(() => told.push(store.timeline.endTick));
  return {
    store,
    told,
    end,
    record: (tick: number) => {
      recorded.reachedTick(tick);
      const news = recorded.take();
      if (news !== null) store.take(news);
    },
    pass: () => waiting.shift()?.(),
  };
}

describe("the page's timeline", () => {
  it("tells the first news at once, and what comes soon after in one go", () => {
    const { told, record, pass, store } = newStore();
    record(1);
    record(2);
    record(3);
    expect(told).toEqual([1]);
    expect(store.timeline.endTick).toBe(3);
    pass();
    expect(told).toEqual([1, 3]);
    record(4);
    expect(told).toEqual([1, 3]);
    pass();
    expect(told).toEqual([1, 3, 4]);
  });

  it("is at rest when nothing comes", () => {
    const { told, record, pass } = newStore();
    record(1);
    pass();
    pass();
    expect(told).toEqual([1]);
    record(2);
    expect(told).toEqual([1, 2]);
  });

  it("tells nobody who has left", () => {
    const { told, record, end } = newStore();
    end();
    record(1);
    expect(told).toEqual([]);
  });
});
