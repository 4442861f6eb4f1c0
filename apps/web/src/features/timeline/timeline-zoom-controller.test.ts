import { describe, expect, it } from "vitest";
import type { Snapshot } from "@corridor/protocol";
import { createRunStore, type RunState } from "../../model/run/run-store.ts";
import { TimelineStore } from "../../model/run/timeline-store.ts";
import { createTimelineZoom } from "./timeline-zoom-store.ts";
import { TimelineZoomController } from "./timeline-zoom-controller.ts";
import type { TimeWindow } from "./time-scale.ts";

/** A controller, and the number of times that it measured the timeline. */
function setUp(window: TimeWindow | null) {
  const zoom = createTimelineZoom();
  zoom.setState({ window });
  const run = createRunStore();
  const measured = { times: 0 };
  const controller = new TimelineZoomController(
    { run, timeline: new TimelineStore() },
    zoom,
    () => {
      measured.times++;
      return 800;
    },
  );
  run.subscribe(controller.follow);
  /** the robot drives to a tick */
  const drive = (tick: number): void =>
    run.setState({ view: "now", nowTick: tick, snapshot: snapshotAt(tick) });
  return { zoom, drive, measured };
}

function snapshotAt(tick: number): RunState["snapshot"] {
  return { tick, state: "running" } as Snapshot;
}

describe("a timeline while the robot drives", () => {
  it("is not measured in a frame while it displays the whole run: that lays out the page", () => {
    const { drive, measured } = setUp(null);
    for (let tick = 15; tick <= 600; tick += 15) drive(tick);
    expect(measured.times).toBe(0);
  });

  it("is not measured while the moment is in the displayed part", () => {
    const { drive, measured } = setUp({ from: 0, span: 600, step: 60 });
    for (let tick = 15; tick <= 600; tick += 15) drive(tick);
    expect(measured.times).toBe(0);
  });

  it("moves its part along once the moment leaves it", () => {
    const { zoom, drive } = setUp({ from: 0, span: 600, step: 60 });
    drive(590);
    drive(605);
    const { window } = zoom.getState();
    expect(window?.from).toBeGreaterThan(0);
    expect(window?.span).toBe(600);
  });

  it("does not move while the user looks at another part", () => {
    const part = { from: 0, span: 600, step: 60 };
    const { zoom, drive } = setUp(part);
    drive(1200);
    drive(1215);
    zoom.setState({ window: part });
    drive(1230);
    expect(zoom.getState().window).toEqual(part);
  });

  it("displays a new run whole", () => {
    const { zoom, drive } = setUp({ from: 0, span: 600, step: 60 });
    drive(300);
    drive(0);
    expect(zoom.getState().window).toBeNull();
  });
});
