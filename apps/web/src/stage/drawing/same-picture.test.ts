import { snapshotOf } from "@corridor/protocol/testing";
import { expect, it } from "vitest";
import type { Frame } from "./frame.ts";
import { isSamePicture } from "./same-picture.ts";
import { frameOf } from "../testing/frame-of.ts";

const snapshot = snapshotOf();
const ghost = { badge: "A", x: 50, y: 50, heading: 0 };
const before = frameOf({ snapshot, ghosts: [ghost] });

it("finds a frame in which only time has passed the same", () => {
  const later = { ...snapshot, tick: snapshot.tick + 1, seq: snapshot.seq + 1 };
  const next = {
    ...before,
    snapshot: later,
    nowTick: later.tick,
    waited: 1,
    ghosts: [{ ...ghost }],
  };
  expect(isSamePicture(before, next)).toBe(true);
});

it.each<[string, Partial<Frame>]>([
  ["a robot that moved", { snapshot: { ...snapshot, pose: { ...snapshot.pose, x: 51 } } }],
  ["a robot that turned", { snapshot: { ...snapshot, pose: { ...snapshot.pose, heading: 1 } } }],
  [
    "another distance",
    {
      snapshot: {
        ...snapshot,
        sensors: { ...snapshot.sensors, front: snapshot.sensors.front + 1 },
      },
    },
  ],
  ["a reached goal", { snapshot: { ...snapshot, goalReached: !snapshot.goalReached } }],
  ["a bump", { bumps: [50, 50] }],
  ["a new corner of the trail", { corners: [50, 50] }],
  ["a trail that starts again", { trailReset: true }],
  ["a tick of the past", { view: "past" }],
  ["a manoeuvre", { progress: { kind: "drive", left: 10 } as Frame["progress"] }],
  ["a ghost that moved", { ghosts: [{ ...ghost, x: 51 }] }],
  ["no ghosts", { ghosts: [] }],
  ["marks of scripts", { marks: [] }],
])("notices %s", (_, change) => {
  expect(isSamePicture(before, { ...before, ...change })).toBe(false);
});
