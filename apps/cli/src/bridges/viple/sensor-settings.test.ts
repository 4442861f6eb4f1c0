import { snapshotOf } from "@corridor/protocol/testing";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { InputError } from "../../input-error.ts";
import { readSensorSettings, sensorMessage } from "./sensor-settings.ts";

const snapshot = snapshotOf({
  sensors: { front: 250.5, right: 50, back: 49.5, left: 12.7 },
  bumping: true,
});

const message = (...[sensor, unit = "cm"]: [sensor?: string[], unit?: string]): unknown =>
  JSON.parse(sensorMessage(snapshot, readSensorSettings({ sensor, unit })));

describe("a message with readings", () => {
  it("has the numbers of VIPLE's Unity simulator by default", () => {
    expect(message()).toEqual({
      sensors: [
        { name: "touch", id: 0, value: 1 },
        { name: "distance", id: 1, value: 50 },
        { name: "distance", id: 2, value: 250.5 },
      ],
    });
  });

  it("has the sensors, names, numbers and unit of the options", () => {
    expect(message(["left=sound:7", "touch=touch:3", "back=0"], "inch")).toEqual({
      sensors: [
        { name: "sound", id: 7, value: 5 },
        { name: "touch", id: 3, value: 1 },
        { name: "distance", id: 0, value: 19.488 },
      ],
    });
  });

  it.each([
    ["mm", 2505],
    ["cm", 250.5],
    ["m", 2.505],
  ])("has distances in %s", (unit, value) => {
    expect(message(["front=2"], unit)).toEqual({ sensors: [{ name: "distance", id: 2, value }] });
  });

  it("contains numbers only, whatever the robot reads", () => {
    const reading = fc.double({ min: 0, max: 51_200, noNaN: true });
    const settings = readSensorSettings({ sensor: ["front=1", "touch=2"], unit: "mm" });
    fc.assert(
      fc.property(reading, fc.boolean(), (front, bumping) => {
        const text = sensorMessage({ sensors: { ...snapshot.sensors, front }, bumping }, settings);
        const { sensors } = JSON.parse(text) as { sensors: { value: unknown }[] };
        expect(sensors[0]?.value).toBeCloseTo(front * 10, 2);
        expect(sensors[1]?.value).toBe(bumping ? 1 : 0);
      }),
    );
  });
});

describe("the options of sensors", () => {
  it.each([
    { name: "a side", sensor: ["top=1"], unit: "cm", expected: "--sensor" },
    { name: "a name", sensor: ["front=radar:1"], unit: "cm", expected: "--sensor" },
    { name: "no number", sensor: ["front"], unit: "cm", expected: "--sensor" },
    { name: "a text as number", sensor: ["front=two"], unit: "cm", expected: "--sensor" },
    { name: "touch as a distance", sensor: ["touch=distance:1"], unit: "cm", expected: "--sensor" },
    { name: "a distance as touch", sensor: ["front=touch:1"], unit: "cm", expected: "--sensor" },
    { name: "a unit", sensor: [], unit: "furlong", expected: "--unit" },
    { name: "a field as unit", sensor: [], unit: "constructor", expected: "--unit" },
  ])("refuse $name", ({ sensor, unit, expected }) => {
    const read = (): unknown => readSensorSettings({ sensor, unit });
    expect(read).toThrow(InputError);
    expect(read).toThrow(expected);
  });
});
