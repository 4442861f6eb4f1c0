import { snapshotOf } from "@corridor/protocol/testing";
import { beforeEach, describe, expect, it } from "vitest";
import { createRunStore, type RunStore } from "../../model/run/run-store.ts";
import { lineFeed } from "./line-feed.ts";

/** The event that a browser fires when it starts or stops rendering a line. */
class SightEvent extends Event {
  readonly skipped: boolean;

  constructor(skipped: boolean) {
    super("contentvisibilityautostatechange");
    this.skipped = skipped;
  }
}

let run: RunStore;
let line: EventTarget;
let received: number[];

beforeEach(() => {
  run = createRunStore();
  line = new EventTarget();
  received = [];
  const feed = lineFeed(run, 0);
  feed.observe(line);
  feed.subscribe(({ snapshot }) => received.push(snapshot?.tick ?? 0));
});

function show(tick: number, state: "running" | "paused" = "running"): void {
  run.setState({ snapshot: snapshotOf({ tick, state }) });
}

describe("a line of the program", () => {
  it("updates on every tick while it is visible", () => {
    for (const tick of [1, 2, 3]) show(tick);
    expect(received).toEqual([1, 2, 3]);
  });

  it("updates on every fourth tick while it is not visible", () => {
    line.dispatchEvent(new SightEvent(true));
    for (let tick = 1; tick <= 8; tick++) show(tick);
    expect(received).toEqual([4, 8]);
  });

  it("is exact when the robot rests, visible or not", () => {
    line.dispatchEvent(new SightEvent(true));
    show(1);
    show(2, "paused");
    expect(received).toEqual([2]);
  });

  it("follows every tick again once it is visible", () => {
    line.dispatchEvent(new SightEvent(true));
    show(1);
    line.dispatchEvent(new SightEvent(false));
    show(2);
    expect(received).toEqual([2]);
  });

  it("receives nothing after the last listener ends", () => {
    let count = 0;
    const end = lineFeed(run, 0).subscribe(() => (count += 1));
    end();
    show(1);
    expect(count).toBe(0);
  });
});
