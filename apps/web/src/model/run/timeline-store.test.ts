import { Timeline } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import { TimelineStore } from "./timeline-store.ts";

/** A store fed by a recording in the worker. */
function newStore() {
  const recorded = new Timeline();
  const store = new TimelineStore();
  const timeline = store.open(() => new Timeline());
  const received: number[] = [];
  const end = store.listen(() => received.push(timeline.endTick));
  const record = (...ticks: number[]) => {
    for (const tick of ticks) recorded.advanceTo(tick);
    const delta = recorded.takeDelta();
    if (delta !== null) store.add(delta);
  };
  return { received, end, record };
}

describe("the page's timeline", () => {
  it("publishes each delta at once, and everything between two frames together", () => {
    const { received, record } = newStore();
    record(1);
    record(2, 3, 4);
    expect(received).toEqual([1, 4]);
  });

  it("publishes nothing without a delta", () => {
    const { received, record } = newStore();
    record(1);
    record();
    expect(received).toEqual([1]);
  });

  it("does not notify removed listeners", () => {
    const { received, record, end } = newStore();
    end();
    record(1);
    expect(received).toEqual([]);
  });

  it("applies all deltas from before it was opened, and notifies once", () => {
    const recorded = new Timeline();
    const store = new TimelineStore();
    const waited: number[] = [];
    store.listen(() => waited.push(store.waitedUpTo(90)));
    for (const tick of [30, 60]) {
      recorded.commands.setWaiting(tick, tick === 30);
      recorded.advanceTo(tick);
      const delta = recorded.takeDelta();
      if (delta !== null) store.add(delta);
    }
    expect(waited).toEqual([]);
    const opened = store.open(() => new Timeline());
    expect(opened.endTick).toBe(60);
    expect(waited).toEqual([30]);
    expect(store.open(() => new Timeline())).toBe(opened);
  });
});
