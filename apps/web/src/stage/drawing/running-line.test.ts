import type { ProgramDocument } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { limitsOf, litSensors } from "./running-line.ts";

const program: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "",
  default: "forward",
  rules: [
    { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
    { when: { sensor: "left", is: ">", than: "right", plus: 1 }, do: "left 90" },
    { when: null, do: "forward" },
    { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
  ],
};

describe("litSensors", () => {
  it.each([
    { line: 0, lit: ["right"] },
    { line: 1, lit: ["left", "right"] },
    { line: 2, lit: [] },
    { line: "default" as const, lit: [] },
    { line: null, lit: [] },
    { line: 99, lit: [] },
  ])("line $line lights $lit", ({ line, lit }) => {
    expect(litSensors(program, { driver: "program", line })).toEqual(lit);
  });

  it("lights nothing while the driver is Me", () => {
    expect(litSensors(program, { driver: "me", line: 0 })).toEqual([]);
  });
});

describe("limitsOf", () => {
  it("shows each number that a sensor is compared with, the running line's first", () => {
    expect(limitsOf(program, { driver: "program", line: 3 })).toEqual([
      { line: 3, sensor: "front", distance: 50, isRunning: true },
      { line: 0, sensor: "right", distance: 60, isRunning: false },
    ]);
  });

  it("shows the running line's number even in a program of 200 lines", () => {
    const rules = Array.from({ length: 200 }, (_, at) => ({
      when: { sensor: "front" as const, is: ">" as const, than: at + 1 },
      do: "forward" as const,
    }));
    const limits = limitsOf({ ...program, rules }, { driver: "program", line: 150 });
    expect(limits[0]).toMatchObject({ line: 150, isRunning: true });
    expect(limits.length).toBeLessThan(10);
  });

  it("shows none while the driver is Me", () => {
    expect(limitsOf(program, { driver: "me", line: null })).toEqual([]);
  });
});
