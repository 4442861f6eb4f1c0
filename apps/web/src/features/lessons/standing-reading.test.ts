import { snapshotOf } from "@corridor/protocol/testing";
import { expect, it } from "vitest";
import { missions } from "./missions/missions.ts";
import { standingReading } from "./standing-reading.ts";

const stopMission = missions
  .map((mission) => mission.challenge)
  .find(({ goal }) => goal.kind === "stop");

it.each([
  { front: 129, reading: 129 },
  { front: 130, reading: null },
  { front: 150, reading: null },
  { front: 170, reading: null },
  { front: 171, reading: 171 },
])("calls a stop at $front cm wrong only outside of 130 to 170 cm", ({ front, reading }) => {
  if (stopMission === undefined) throw new Error("no mission asks for a stop");
  const snapshot = snapshotOf({
    tick: 60,
    driver: "me",
    motion: "stop",
    sensors: { front, right: 50, back: 100, left: 50 },
  });
  expect(standingReading(stopMission, { snapshot, view: "now" })).toBe(reading);
});
