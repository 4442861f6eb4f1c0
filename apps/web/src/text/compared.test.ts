import { describe, expect, it } from "vitest";
import { roundedReadings } from "./compared.ts";

const readings = { front: 49.9999, right: 60.04, back: 250.46, left: 61.06 };

describe("the readings of one moment", () => {
  it("are whole where nothing is compared", () => {
    expect(roundedReadings(readings, [null])).toEqual({
      front: 50,
      right: 60,
      back: 250,
      left: 61,
    });
  });

  it("have decimals only where a whole number would contradict a comparison", () => {
    const shown = roundedReadings(readings, [
      { sensor: "front", is: "<", than: 75 },
      { sensor: "front", is: "<", than: 50 },
      { sensor: "right", is: ">", than: 60 },
      { sensor: "back", is: ">", than: 60 },
    ]);
    expect(shown).toEqual({ front: 49.99, right: 60.04, back: 250, left: 61 });
  });

  it("agree with a comparison of left with right", () => {
    const shown = roundedReadings(readings, [{ sensor: "left", is: ">", than: "right", plus: 1 }]);
    expect(shown.left).toBeGreaterThan(shown.right + 1);
  });
});
