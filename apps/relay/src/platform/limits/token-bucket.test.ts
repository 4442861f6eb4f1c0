import { describe, expect, it } from "vitest";
import { TokenBucket } from "./token-bucket.ts";

describe("TokenBucket", () => {
  it("gives a burst at once, then so many a second", () => {
    const bucket = new TokenBucket({ perSecond: 20, burst: 40 }, 0);
    const atOnce = Array.from({ length: 60 }, () => bucket.take(0)).filter((wait) => wait === 0);
    expect(atOnce).toHaveLength(40);
    let given = 0;
    for (let now = 1; now <= 2_000; now++) if (bucket.take(now) === 0) given += 1;
    expect(given).toBe(40);
  });

  it("says after how long the next one is there", () => {
    const bucket = new TokenBucket({ perSecond: 20, burst: 1 }, 0);
    bucket.take(0);
    const wait = bucket.take(0);
    expect(wait).toBeCloseTo(50);
    expect(bucket.take(wait)).toBe(0);
  });

  it("neither gives nor takes when the clock is set back", () => {
    const bucket = new TokenBucket({ perSecond: 20, burst: 2 }, 1_000);
    bucket.take(1_000);
    expect(bucket.take(0)).toBe(0);
    expect(bucket.take(0)).toBeGreaterThan(0);
    expect(bucket.isFull(10_000)).toBe(true);
  });
});
