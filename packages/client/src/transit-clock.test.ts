import { describe, expect, it } from "vitest";
import { TransitClock } from "./transit-clock.ts";

/** The relay's clock is an hour ahead. */
const AHEAD = 3_600_000;

/** The page sends `hello` at 1,000 and receives the welcome. */
function welcomed(at: number, now: number) {
  const transit = new TransitClock();
  transit.helloSent(1_000);
  transit.answered(at + AHEAD, now);
  return transit;
}

describe("the transit time of a message", () => {
  it("is half of the round trip at first", () => {
    expect(welcomed(1_020, 1_040).transitMs(1_020 + AHEAD, 1_040)).toBe(20);
  });

  it("includes delays, for any difference of the clocks", () => {
    const transit = welcomed(1_020, 1_040);
    expect(transit.transitMs(2_000 + AHEAD, 2_020)).toBe(20);
    expect(transit.transitMs(3_000 + AHEAD, 8_000)).toBe(5_000);
  });

  it("includes the delay of the welcome itself", () => {
    const transit = welcomed(1_020, 6_000);
    expect(transit.transitMs(1_020 + AHEAD, 6_000)).toBe(4_950);
    expect(transit.transitMs(5_900 + AHEAD, 6_000)).toBeGreaterThanOrEqual(70);
  });

  it("is never underestimated by more than 50 ms, wherever the delay was", () => {
    for (const toRelay of [0, 20, 400, 3_000]) {
      for (const toPage of [0, 20, 400, 3_000]) {
        const relayAt = 1_000 + toRelay;
        const transit = welcomed(relayAt, relayAt + toPage);
        const sent = relayAt + 5_000;
        expect(transit.transitMs(sent + AHEAD, sent + 700)).toBeGreaterThanOrEqual(700 - 50);
      }
    }
  });

  it("is at most the time since `hello`, before the first response", () => {
    const transit = new TransitClock();
    transit.helloSent(1_000);
    expect(transit.transitMs(1_010 + AHEAD, 3_000)).toBe(2_000);
    transit.answered(1_010 + AHEAD, 3_000);
    expect(transit.transitMs(1_010 + AHEAD, 3_000)).toBe(1_950);
  });

  it("adapts to a message that was faster than the estimate permits", () => {
    const transit = welcomed(1_000, 1_040);
    expect(transit.transitMs(2_000 + AHEAD, 2_700)).toBe(680);
    expect(transit.transitMs(3_000 + AHEAD, 3_000)).toBe(0);
    expect(transit.transitMs(4_000 + AHEAD, 4_700)).toBe(700);
  });

  it("becomes precise with a fast response, and never less precise", () => {
    const transit = welcomed(4_000, 4_010);
    expect(transit.isImprecise).toBe(true);
    transit.timeRequested(5_000);
    expect(transit.isImprecise).toBe(false);
    transit.answered(5_010 + AHEAD, 9_000);
    expect(transit.isImprecise).toBe(true);
    transit.timeRequested(9_500);
    transit.answered(9_510 + AHEAD, 9_520);
    expect(transit.isImprecise).toBe(false);
    expect(transit.transitMs(10_000 + AHEAD, 10_010)).toBe(10);
  });

  it("is measured again after each `hello`", () => {
    const transit = welcomed(1_020, 1_040);
    transit.helloSent(9_000);
    transit.answered(500, 9_010);
    expect(transit.transitMs(500, 9_010)).toBe(5);
  });
});
