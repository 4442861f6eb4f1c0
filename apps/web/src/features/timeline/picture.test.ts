import { Timeline } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import { pictureMark, pictureOf } from "./picture.ts";

const HOUR = 216_000;

/** A timeline whose line 1 drives until a tick. */
function timelineUpTo(tick: number): Timeline {
  const timeline = new Timeline();
  timeline.recordDriver(0, 1);
  timeline.advanceTo(tick);
  return timeline;
}

/** The text that distinguishes the picture from others. */
function markOf(timeline: Timeline, width = 400): string {
  return pictureMark(pictureOf(timeline, width));
}

describe("the picture of a run that continues", () => {
  it("stays the same while new segments are narrower than a pixel", () => {
    const timeline = timelineUpTo(HOUR - 600);
    const before = markOf(timeline);
    timeline.advanceTo(HOUR - 590);
    expect(markOf(timeline)).toBe(before);
    timeline.advanceTo(HOUR);
    expect(markOf(timeline)).not.toBe(before);
  });

  it("looks different when another line drives, and at another width", () => {
    const timeline = timelineUpTo(600);
    const before = markOf(timeline);
    expect(markOf(timeline, 500)).not.toBe(before);
    timeline.recordDriver(601, 2);
    timeline.advanceTo(602);
    expect(markOf(timeline)).not.toBe(before);
  });
});
