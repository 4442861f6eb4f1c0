import { describe, expect, it } from "vitest";
import { isTemporary, retryDelay } from "./temporary-failure.ts";

describe("a response", () => {
  it.each([408, 425, 429, 500, 502, 503, 504, 507])("with the status %i is temporary", (status) => {
    expect(isTemporary({ status })).toBe(true);
  });

  it.each([200, 304, 400, 401, 403, 404, 409, 410, 413, 415, 421, 422])(
    "with the status %i is final",
    (status) => {
      expect(isTemporary({ status })).toBe(false);
    },
  );

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
