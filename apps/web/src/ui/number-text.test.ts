import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { readNumber } from "./number-text.ts";

const distance = { min: 0, max: 100_000 };

describe("readNumber", () => {
  it.each([
    ["60", 60],
    [" 60 ", 60],
    ["60.5", 60.5],
    ["60,5", 60.5],
    ["5.", 5],
    [".5", 0.5],
    ["0", 0],
    ["-0", 0],
    ["６０", 60],
    ["６０．５", 60.5],
    ["٦٠", 60],
    ["٦٠٫٥", 60.5],
    ["100000", 100_000],
  ])("reads %j as %d", (text, number) => {
    expect(readNumber(text, distance)).toBe(number);
  });

  it.each(["", " ", "-1", "100001", "abc", "6O", "1e3", "1,000.5", "--1", ".", "Infinity", "NaN"])(
    "refuses %j as a distance",
    (text) => {
      expect(readNumber(text, distance)).toBeNull();
    },
  );

  it("accepts negative numbers, with a hyphen or a minus sign, if they are allowed", () => {
    const signed = { min: -100, max: 100 };
    expect(readNumber("-1", signed)).toBe(-1);
    expect(readNumber("−1", signed)).toBe(-1);
  });

  it("accepts only integers if fractions make no sense", () => {
    expect(readNumber("4.5", { min: 1, max: 256, whole: true })).toBeNull();
    expect(readNumber("4", { min: 1, max: 256, whole: true })).toBe(4);
  });

  it("parses every valid distance with up to four decimals", () => {
    fc.assert(
      fc.property(fc.integer({ min: 0, max: 1_000_000_000 }), (tenThousandths) => {
        const number = tenThousandths / 10_000;
        expect(readNumber(String(number), distance)).toBe(number < 1e-6 ? 0 : number);
      }),
    );
  });
});
