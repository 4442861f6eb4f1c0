import { describe, expect, it } from "vitest";
import { languages } from "./languages.ts";
import { formatClock, formatReading, formatSeconds, localNumber } from "./numbers.ts";

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
  it("has the same tenths as the clock", () => {
    expect(formatSeconds(2352)).toBe("39.2");
    expect(formatSeconds(3599)).toBe("59.9");
  });
});

describe("the decimal sign", () => {
  it.each([
    ["en", "250.5", "0:17.7", "39.2"],
    ["de", "250,5", "0:17,7", "39,2"],
    ["es", "250,5", "0:17,7", "39,2"],
    ["fr", "250,5", "0:17,7", "39,2"],
    ["pt", "250,5", "0:17,7", "39,2"],
    ["ja", "250.5", "0:17.7", "39.2"],
    ["zh-Hans", "250.5", "0:17.7", "39.2"],
    ["ar", "250.5", "0:17.7", "39.2"],
  ])("of %s makes %s, %s and %s", (language, reading, clock, seconds) => {
    expect(formatReading(250.5, language)).toBe(reading);
    expect(formatClock(1063, language)).toBe(clock);
    expect(formatSeconds(2352, language)).toBe(seconds);
  });
});

describe("the signs of a number", () => {
  it.each(languages)("are those that Intl has for $name", ({ tag }) => {
    const intl = new Intl.NumberFormat(tag, { numberingSystem: "latn" });
    for (const number of [-0.5, 12.5, -48.25]) {
      expect(localNumber(String(number), tag)).toBe(intl.format(number));
    }
  });
});

describe("a negative number", () => {
  it("keeps its minus before its figures where text runs the other way", () => {
    expect(localNumber("> -20.5", "de")).toBe("> -20,5");
    expect(localNumber("> -20.5", "ar")).toBe("> \u200E-20.5");
  });
});
