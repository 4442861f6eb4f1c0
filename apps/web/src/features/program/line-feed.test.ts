import { snapshotOf } from "@corridor/protocol/testing";
import { beforeEach, describe, expect, it } from "vitest";
import { createRunStore, type RunStore } from "../../stores/run-store.ts";
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
let told: number[];

beforeEach(() => {
  run = createRunStore();
  line = new EventTarget();
  told = [];
  const feed = lineFeed(run, 0);
  feed.watch(line);
  feed.subscribe(({ snapshot }) => told.push(snapshot?.tick ?? 0));
});

function show(tick: number, state: "running" | "paused" = "running"): void {
  run.setState({ snapshot: snapshotOf({ tick, state }) });
}

describe("a line of the program", () => {
  it("follows every moment while it is in sight", () => {
    for (const tick of [1, 2, 3]) show(tick);
    expect(told).toEqual([1, 2, 3]);
  });

  it("follows at every fourth while it is out of sight", () => {
    line.dispatchEvent(new SightEvent(true));
    for (let tick = 1; tick <= 8; tick++) show(tick);
    expect(told).toEqual([4, 8]);
  });

  it("is exact when the robot rests, in sight or not", () => {
    line.dispatchEvent(new SightEvent(true));
    show(1);
    show(2, "paused");
    expect(told).toEqual([2]);
  });

  it("follows every moment again once it has come into sight", () => {
    line.dispatchEvent(new SightEvent(true));
    show(1);
    line.dispatchEvent(new SightEvent(false));
    show(2);
    expect(told).toEqual([2]);
  });

  it("hears nothing more once nobody listens", () => {
    let heard = 0;
    const end = lineFeed(run, 0).subscribe(() => (heard += 1));
    end();
    show(1);
    expect(heard).toBe(0);
  });
});
