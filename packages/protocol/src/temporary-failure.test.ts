import { describe, expect, it } from "vitest";
import { isTemporary } from "./temporary-failure.ts";

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
});
