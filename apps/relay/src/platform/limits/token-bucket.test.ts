import { describe, expect, it } from "vitest";
import { TokenBucket } from "./token-bucket.ts";

describe("TokenBucket", () => {
  it("permits a burst immediately, then the rate", () => {
    const bucket = new TokenBucket({ perSecond: 20, burst: 40 }, 0);
    const atOnce = Array.from({ length: 60 }, () => bucket.take(0)).filter((wait) => wait === 0);
    expect(atOnce).toHaveLength(40);
    let given = 0;
    for (let now = 1; now <= 2_000; now++) if (bucket.take(now) === 0) given += 1;
    expect(given).toBe(40);
  });

  it("returns the time until the next token", () => {
    const bucket = new TokenBucket({ perSecond: 20, burst: 1 }, 0);
    bucket.take(0);
    const wait = bucket.take(0);
    expect(wait).toBeCloseTo(50);
    expect(bucket.take(wait)).toBe(0);
  });

  it("adds and removes no tokens when the clock is set back", () => {
    const bucket = new TokenBucket({ perSecond: 20, burst: 2 }, 1_000);
    bucket.take(1_000);
    expect(bucket.take(0)).toBe(0);
    expect(bucket.take(0)).toBeGreaterThan(0);
    expect(bucket.isFull(10_000)).toBe(true);
  });
});
