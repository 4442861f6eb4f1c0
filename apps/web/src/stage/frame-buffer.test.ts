import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { FrameBuffer } from "./frame-buffer.ts";
import { frameOf } from "./testing/frame-of.ts";

const snapshot = snapshotOf();

describe("the newest frame", () => {
  it("contains everything that the trail gained since the last one was taken", () => {
    const frames = new FrameBuffer();
    expect(frames.take()).toBeNull();
    frames.add(frameOf({ snapshot, corners: [1, 2], bumps: [5, 6], trailReset: true }));
    frames.add(frameOf({ snapshot: { ...snapshot, tick: 2 }, corners: [3, 4], bumps: [7, 8] }));
    expect(frames.take()).toMatchObject({
      snapshot: { tick: 2 },
      corners: [1, 2, 3, 4],
      bumps: [5, 6, 7, 8],
      trailReset: true,
    });
    expect(frames.take()).toMatchObject({ corners: [], bumps: [], trailReset: false });
  });

  it("drops the trail from before a reset", () => {
    const frames = new FrameBuffer();
    frames.add(frameOf({ snapshot, corners: [1, 2], trailReset: false }));
    frames.add(frameOf({ snapshot, corners: [9, 9], trailReset: true }));
    expect(frames.take()).toMatchObject({ corners: [9, 9], trailReset: true });
  });

  it("contains only the newest part of the trail after the page was hidden for hours", () => {
    const frames = new FrameBuffer();
    const corners = Array.from({ length: 60_000 }, (_, i) => i);
    frames.add(frameOf({ snapshot, corners, trailReset: false }));
    const frame = frames.take();
    expect(frame?.corners).toHaveLength(40_000);
    expect(frame?.corners.at(-1)).toBe(59_999);
    expect(frame?.trailReset).toBe(true);
  });

  it("retains the bumps from before the page was hidden, but not their part of the trail", () => {
    const frames = new FrameBuffer();
    frames.add(frameOf({ snapshot, bumps: [1, 1], trailReset: true }));
    frames.add(frameOf({ snapshot, bumps: [5, 6] }));
    frames.take();
    const corners = Array.from({ length: 60_000 }, (_, i) => i);
    frames.add(frameOf({ snapshot, corners, bumps: [7, 8], trailReset: false }));
    expect(frames.take()).toMatchObject({ bumps: [1, 1, 5, 6, 7, 8], trailReset: true });
    frames.add(frameOf({ snapshot, bumps: [9, 9] }));
    expect(frames.take()).toMatchObject({ bumps: [9, 9], trailReset: false });
  });
});
