import { describe, expect, it } from "vitest";
import { retryDelay } from "./retry-delay.ts";

describe("a response", () => {
  it.each([
    { retryAfter: undefined, ms: 200 },
    { retryAfter: null, ms: 200 },
    { retryAfter: "5", ms: 5_200 },
    { retryAfter: "Fri, 31 Dec 1999 23:59:59 GMT", ms: 200 },
    { retryAfter: "86400", ms: 60_200 },
  ])("with Retry-After $retryAfter is followed by a delay of $ms ms", ({ retryAfter, ms }) => {
    const header = retryAfter === undefined ? {} : { retryAfter };
    expect(retryDelay({ status: 503, body: "", ...header }, 200)).toBe(ms);
  });
});
