import { describe, expect, it } from "vitest";
import { closeReasonOf, closeReasons } from "./close-codes.ts";

describe("closeReasonOf", () => {
  it.each(Object.entries(closeReasons))("knows %s by its code", (_name, reason) => {
    expect(closeReasonOf(reason.code)).toBe(reason);
    expect(reason.remedy).toMatch(/^[A-Z].*\.$/);
  });

  it("takes any other code for a lost line, which is tried again", () => {
    for (const code of [1000, 1001, 1006, 1009, 4999]) {
      expect(closeReasonOf(code)).toMatchObject({ code, retry: true });
    }
  });

  it("forbids a retry exactly where the same connection can never succeed", () => {
    const final = Object.values(closeReasons).filter(({ retry }) => !retry);
    expect(final.map(({ code }) => code)).toEqual([4401, 4403, 4404, 4409, 4410]);
  });
});
