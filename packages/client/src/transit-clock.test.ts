import { describe, expect, it } from "vitest";
import { TransitClock } from "./transit-clock.ts";

/** The relay's clock is an hour ahead. */
const AHEAD = 3_600_000;

function greeted() {
  const transit = new TransitClock();
  transit.greeted(1_000);
  return transit;
}

describe("how long a message was on its way", () => {
  it("is half of the way there and back, to begin with", () => {
    expect(greeted().came(1_020 + AHEAD, 1_040)).toBe(20);
  });

  it("is told of one that was held up, whatever the clocks say", () => {
    const transit = greeted();
    transit.came(1_020 + AHEAD, 1_040);
    expect(transit.came(2_000 + AHEAD, 2_020)).toBe(20);
    expect(transit.came(3_000 + AHEAD, 8_000)).toBe(5_000);
  });

  it("is counted as a quarter of a second at most for a greeting that was answered late", () => {
    const transit = greeted();
    expect(transit.came(4_980 + AHEAD, 5_000)).toBe(250);
    expect(transit.came(5_100 + AHEAD, 5_110)).toBe(240);
  });

  it("begins anew with each greeting", () => {
    const transit = greeted();
    transit.came(1_020 + AHEAD, 1_040);
    transit.greeted(9_000);
    expect(transit.came(500, 9_010)).toBe(5);
  });
});
