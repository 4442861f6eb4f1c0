import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { frameOf } from "../../stage/testing/frame-of.ts";
import { RunTrace } from "./run-trace.ts";

function at(x: number, y: number) {
  return snapshotOf({ pose: { x, y, heading: 90 } });
}

describe("the run trace for pictures", () => {
  it("is null before the first frame", () => {
    expect(new RunTrace().take()).toBeNull();
  });

  it("has the whole trail up to the robot, and every bump", () => {
    const run = new RunTrace();
    run.add(frameOf({ snapshot: at(50, 50), corners: [50, 50], trailReset: true }));
    run.add(frameOf({ snapshot: at(250, 50), bumps: [250, 50] }));
    run.add(frameOf({ snapshot: at(250, 90), corners: [250, 50], bumps: [250, 90] }));
    expect(run.take()).toEqual({
      snapshot: at(250, 90),
      points: [50, 50, 250, 50, 250, 90],
      bumps: [250, 50, 250, 90],
    });
  });

  it("restarts with the trail", () => {
    const run = new RunTrace();
    run.add(frameOf({ snapshot: at(50, 50), corners: [50, 50], trailReset: true }));
    run.add(frameOf({ snapshot: at(250, 50), bumps: [250, 50] }));
    run.add(frameOf({ snapshot: at(150, 150), corners: [150, 150], trailReset: true }));
    expect(run.take()).toMatchObject({ points: [150, 150, 150, 150], bumps: [] });
  });
});
