import { snapshotOf } from "@corridor/protocol/testing";
import type { ProgramDocument } from "@corridor/program";
import type { Snapshot } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { readSensors } from "./sensor-roles.ts";

const program: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "",
  default: "forward",
  rules: [
    { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
    { when: { sensor: "left", is: ">", than: "right", plus: 1 }, do: "left 90" },
    { when: null, do: "forward" },
  ],
};

function at(changes: Partial<Snapshot>): Snapshot {
  const sensors = { front: 50, right: 50, back: 50, left: 50 };
  return snapshotOf({ driver: "program", motion: "forward", sensors, ...changes });
}

describe("readSensors", () => {
  it.each([
    { name: "no line decides", line: null, sensors: [] },
    { name: "otherwise decides", line: "default" as const, sensors: [] },
    { name: "a line with one sensor decides", line: 0, sensors: ["front"] },
    { name: "a line that compares decides", line: 1, sensors: ["left", "right"] },
    { name: "the deciding line was just deleted", line: 9, sensors: [] },
  ])("lights $sensors when $name", ({ line, sensors }) => {
    expect(readSensors(program, at({ line }))).toEqual(sensors);
  });

  it("lights nothing before the first snapshot", () => {
    expect(readSensors(program, null)).toEqual([]);
  });
});
