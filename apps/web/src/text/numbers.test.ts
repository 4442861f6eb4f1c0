import { describe, expect, it } from "vitest";
import { formatClock, formatReading, formatSeconds } from "./numbers.ts";

describe("formatReading", () => {
  it.each([
    [250, "250"],
    [250.46, "250.5"],
    [50.04, "50"],
    [49.96, "50"],
    [0.3, "0.3"],
  ])("shows %d cm as %s", (value, text) => {
    expect(formatReading(value)).toBe(text);
  });
});

describe("formatClock", () => {
  it.each([
    [0, "0:00.0"],
    [1063, "0:17.7"],
    [3599, "0:59.9"],
    [3600, "1:00.0"],
    [36_030, "10:00.5"],
    [360_000, "100:00.0"],
  ])("shows tick %d as %s", (tick, text) => {
    expect(formatClock(tick)).toBe(text);
  });
});

describe("formatSeconds", () => {
  it("tells the same tenths as the clock", () => {
    expect(formatSeconds(2352)).toBe("39.2");
    expect(formatSeconds(3599)).toBe("59.9");
  });
});
