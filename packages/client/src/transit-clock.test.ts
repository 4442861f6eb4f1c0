import { describe, expect, it } from "vitest";
import { TransitClock } from "./transit-clock.ts";

/** The relay's clock is an hour ahead. */
const AHEAD = 3_600_000;

/** The page greets at 1,000 and the answer comes. */
function welcomed(at: number, now: number) {
  const transit = new TransitClock();
  transit.greeted(1_000);
  transit.answered(at + AHEAD, now);
  return transit;
}

describe("how long a message was on its way", () => {
  it("is half of the way there and back, to begin with", () => {
    expect(welcomed(1_020, 1_040).came(1_020 + AHEAD, 1_040)).toBe(20);
  });

  it("is told of one that was held up, whatever the clocks say", () => {
    const transit = welcomed(1_020, 1_040);
    expect(transit.came(2_000 + AHEAD, 2_020)).toBe(20);
    expect(transit.came(3_000 + AHEAD, 8_000)).toBe(5_000);
  });

  it("counts in full where the welcome itself was held up, with what came behind it", () => {
    const transit = welcomed(1_020, 6_000);
    expect(transit.came(1_020 + AHEAD, 6_000)).toBe(4_950);
    expect(transit.came(5_900 + AHEAD, 6_000)).toBeGreaterThanOrEqual(70);
  });

  it("is never thought shorter than it was by more than 50 ms, wherever the greeting waited", () => {
    for (const wayThere of [0, 20, 400, 3_000]) {
      for (const wayBack of [0, 20, 400, 3_000]) {
        const relayAt = 1_000 + wayThere;
        const transit = welcomed(relayAt, relayAt + wayBack);
        const sent = relayAt + 5_000;
        expect(transit.came(sent + AHEAD, sent + 700)).toBeGreaterThanOrEqual(700 - 50);
      }
    }
  });

  it("is at most what passed since the greeting, before that is answered", () => {
    const transit = new TransitClock();
    transit.greeted(1_000);
    expect(transit.came(1_010 + AHEAD, 3_000)).toBe(2_000);
    transit.answered(1_010 + AHEAD, 3_000);
    expect(transit.came(1_010 + AHEAD, 3_000)).toBe(1_950);
  });

  it("learns from a message that came faster than was thought possible", () => {
    const transit = welcomed(1_000, 1_040);
    expect(transit.came(2_000 + AHEAD, 2_700)).toBe(680);
    expect(transit.came(3_000 + AHEAD, 3_000)).toBe(0);
    expect(transit.came(4_000 + AHEAD, 4_700)).toBe(700);
  });

  it("is known well again once an answer is quick, and worse by none", () => {
    const transit = welcomed(4_000, 4_010);
    expect(transit.isVague).toBe(true);
    transit.asked(5_000);
    expect(transit.isVague).toBe(false);
    transit.answered(5_010 + AHEAD, 9_000);
    expect(transit.isVague).toBe(true);
    transit.asked(9_500);
    transit.answered(9_510 + AHEAD, 9_520);
    expect(transit.isVague).toBe(false);
    expect(transit.came(10_000 + AHEAD, 10_010)).toBe(10);
  });

  it("begins anew with each greeting", () => {
    const transit = welcomed(1_020, 1_040);
    transit.greeted(9_000);
    transit.answered(500, 9_010);
    expect(transit.came(500, 9_010)).toBe(5);
  });
});
