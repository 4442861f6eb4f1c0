import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { limits } from "../../platform/limits/limits.ts";
import { ScriptClocks, TransitEstimate } from "./script-clocks.ts";

const AT = Date.UTC(2026, 0, 1);

it("two scripts of one key on different computers have separate clocks", () => {
  const clocks = new ScriptClocks();
  clocks.measure("key", { clock: "computer-1", sentAt: 9_000_000 }, AT);
  expect(clocks.measure("key", { clock: "computer-2", sentAt: 5 }, AT)).toBe(0);
  expect(clocks.measure("key", { clock: "computer-2", sentAt: 1_005 }, AT + 1_000)).toBe(0);
});

it("a clock id of one key is separate from the same id of another key", () => {
  const clocks = new ScriptClocks();
  clocks.measure("key 1", { clock: "the-same-id", sentAt: 9_000_000 }, AT);
  expect(clocks.measure("key 2", { clock: "the-same-id", sentAt: 5 }, AT)).toBe(0);
});

it("a key with ever more clocks loses the oldest one, never one in use", () => {
  const clocks = new ScriptClocks();
  const held = (): number =>
    clocks.measure("key", { clock: "in-use-01", sentAt: 1_000 }, AT + 3_000);
  clocks.measure("key", { clock: "in-use-01", sentAt: 0 }, AT);
  clocks.measure("key", { clock: "idle-0001", sentAt: 0 }, AT);
  for (let n = 0; n < 10 * limits.clocksPerKey; n++) {
    clocks.measure("key", { clock: `other-${n}`, sentAt: 0 }, AT);
    expect(held()).toBeGreaterThan(1_900);
  }
  expect(clocks.measure("key", { clock: "idle-0001", sentAt: 0 }, AT + 3_000)).toBe(0);
});

it("a request without a time has no transit", () => {
  expect(new ScriptClocks().measure("key", null, AT)).toBe(0);
});

const HOUR_MS = 3_600_000;
/** The relay's clock is years ahead of the script's. */
const RELAY_MS = Date.UTC(2026, 0, 1);

describe("the transit estimate: the delay of a message compared with the fastest one", () => {
  it("is zero for the first message, and for each message that is as fast", () => {
    const transit = new TransitEstimate();
    expect(transit.measure(0, RELAY_MS)).toBe(0);
    expect(transit.measure(1_000, RELAY_MS + 1_000)).toBe(0);
  });

  it("is the delay of a message, independent of the clocks' offset", () => {
    const transit = new TransitEstimate();
    transit.measure(5_000, RELAY_MS);
    expect(transit.measure(6_000, RELAY_MS + 4_000)).toBeCloseTo(3_000, -1);
    expect(transit.measure(9_000, RELAY_MS + 4_000)).toBe(0);
  });

  it("is relative to the fastest message, even if the first one was slow", () => {
    const transit = new TransitEstimate();
    transit.measure(0, RELAY_MS + 3_000);
    expect(transit.measure(4_000, RELAY_MS + 4_000)).toBe(0);
    expect(transit.measure(5_000, RELAY_MS + 8_000)).toBeCloseTo(3_000, -1);
  });

  it("is never raised by drift alone, in sessions and pauses of any length", () => {
    const drifts = fc.double({ min: -100, max: 100, noNaN: true });
    const pauses = fc.array(fc.integer({ min: 1, max: HOUR_MS }), { minLength: 1, maxLength: 50 });
    fc.assert(
      fc.property(drifts, pauses, (partsPerMillion, gaps) => {
        const transit = new TransitEstimate();
        transit.measure(0, RELAY_MS);
        let passed = 0;
        for (const gap of gaps) {
          passed += gap;
          const sentAt = passed * (1 + partsPerMillion / 1e6);
          expect(transit.measure(sentAt, RELAY_MS + passed)).toBeLessThanOrEqual(1);
        }
      }),
    );
  });

  it("still detects a delay after hours: drift hides at most 18 ms per minute without a fast message", () => {
    const drifts = fc.double({ min: -100, max: 100, noNaN: true });
    const delays = fc.integer({ min: 0, max: 10_000 });
    fc.assert(
      fc.property(
        drifts,
        delays,
        fc.integer({ min: 0, max: 12 * HOUR_MS }),
        (partsPerMillion, delayMs, quietMs) => {
          const transit = new TransitEstimate();
          transit.measure(0, RELAY_MS);
          const sentAt = quietMs * (1 + partsPerMillion / 1e6);
          const hidden = 0.0003 * (quietMs + delayMs) + 1;
          expect(transit.measure(sentAt, RELAY_MS + quietMs + delayMs)).toBeGreaterThanOrEqual(
            delayMs - hidden,
          );
        },
      ),
    );
  });

  it("is a number that is not negative, for any timestamps of a sender", () => {
    const claims = fc.double({ min: 0, max: 999_999_999_999_999, noNaN: true });
    fc.assert(
      fc.property(fc.array(claims, { minLength: 1 }), (times) => {
        const transit = new TransitEstimate();
        for (const [n, sentAt] of times.entries()) {
          const ms = transit.measure(sentAt, RELAY_MS + n);
          expect(Number.isFinite(ms) && ms >= 0).toBe(true);
        }
      }),
    );
  });
});
