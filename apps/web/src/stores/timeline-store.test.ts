import { Timeline } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import { TimelineStore } from "./timeline-store.ts";

/** A store fed by a recording in the worker. */
function newStore() {
  const recorded = new Timeline();
  const store = new TimelineStore();
  const timeline = store.open(() => new Timeline());
  const told: number[] = [];
  const end = store.listen(() => told.push(timeline.endTick));
  const record = (...ticks: number[]) => {
    for (const tick of ticks) recorded.advanceTo(tick);
    const news = recorded.takeDelta();
    if (news !== null) store.take(news);
  };
  return { told, end, record };
}

describe("the page's timeline", () => {
  it("tells the news at once, and what came between two frames in one go", () => {
    const { told, record } = newStore();
    record(1);
    record(2, 3, 4);
    expect(told).toEqual([1, 4]);
  });

  it("is at rest when nothing comes", () => {
    const { told, record } = newStore();
    record(1);
    record();
    expect(told).toEqual([1]);
  });

  it("tells nobody who has left", () => {
    const { told, record, end } = newStore();
    end();
    record(1);
    expect(told).toEqual([]);
  });

  it("has all that came before it was opened, and tells so", () => {
    const recorded = new Timeline();
    const store = new TimelineStore();
    const waited: number[] = [];
    store.listen(() => waited.push(store.waitedUpTo(90)));
    for (const tick of [30, 60]) {
      recorded.commands.setWaiting(tick, tick === 30);
      recorded.advanceTo(tick);
      const news = recorded.takeDelta();
      if (news !== null) store.take(news);
    }
    expect(waited).toEqual([]);
    const opened = store.open(() => new Timeline());
    expect(opened.endTick).toBe(60);
    expect(waited).toEqual([30]);
    expect(store.open(() => new Timeline())).toBe(opened);
  });
});
