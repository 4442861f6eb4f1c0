import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { createRunStore, truncateRun } from "../../model/run/run-store.ts";
import { missions } from "../../model/lessons/missions/missions.ts";
import { stationaryRobot } from "./stationary-robot.ts";

const challenges = missions.map(({ challenge }) => challenge);
const stopMission = challenges.find(({ goal }) => goal.kind === "stop");
const reachMission = challenges.find(({ allowed }) => allowed.drivers[0] === "me");
if (stopMission === undefined || reachMission === undefined) throw new Error("no such mission");

const stationary = (front: number) =>
  snapshotOf({
    tick: 60,
    driver: "me",
    motion: "stop",
    sensors: { front, right: 50, back: 100, left: 50 },
  });

it.each([
  { front: 129, reading: 129 },
  { front: 130, reading: null },
  { front: 150, reading: null },
  { front: 170, reading: null },
  { front: 171, reading: 171 },
])("calls a stop at $front cm wrong only outside of 130 to 170 cm", ({ front, reading }) => {
  const robot = stationaryRobot(stopMission, {
    snapshot: stationary(front),
    isCut: false,
    view: "now",
  });
  expect(robot?.reading ?? null).toBe(reading);
});

it("gives no advice after a reset for the place where the robot stood before", () => {
  const run = createRunStore();
  run.setState({ snapshot: stationary(25) });
  expect(stationaryRobot(stopMission, run.getState())?.reading).toBe(25);
  truncateRun(run, 60);
  expect(stationaryRobot(stopMission, run.getState())?.reading).toBe(25);
  truncateRun(run, -1);
  expect(stationaryRobot(stopMission, run.getState())).toBeNull();
});

describe("a robot on its way to a place", () => {
  const at = (goal: (typeof reachMission)["goal"], changes: Parameters<typeof snapshotOf>[0]) =>
    stationaryRobot(
      { ...reachMission, goal },
      {
        snapshot: snapshotOf({ ...stationary(300), ...changes }),
        isCut: false,
        view: "now",
      },
    );

  it("stands before it once it has stopped", () => {
    expect(at({ kind: "reach" }, {})).toEqual({ ...stationary(300).pose, reading: null });
  });

  it.each([
    { why: "drives", changes: { motion: "forward" as const } },
    { why: "has not moved", changes: { tick: 0 } },
    { why: "has arrived", changes: { goalReached: true } },
  ])("does not while it $why", ({ changes }) => {
    expect(at({ kind: "reach" }, changes)).toBeNull();
  });

  it("stands nowhere where no place is the goal", () => {
    expect(at({ kind: "visit" }, {})).toBeNull();
    expect(at({ kind: "drive", distance: 500 }, {})).toBeNull();
  });
});
