import { describe, expect, it } from "vitest";
import { closeReasonOf, closeReasons } from "./close-codes.ts";

describe("closeReasonOf", () => {
  it.each(Object.entries(closeReasons))("finds %s by its code", (_name, reason) => {
    expect(closeReasonOf(reason.code)).toBe(reason);
    expect(reason.remedy).toMatch(/^[A-Z].*\.$/);
  });

  it.each(["noRobot", "over"] as const)("fits into a close frame: %s", (name) => {
    const { cause, remedy } = closeReasons[name];
    expect(`${cause}. ${remedy}`.length).toBeLessThanOrEqual(123);
    // The glossary has no sessions: a robot is registered and deleted.
    expect(`${cause}. ${remedy}`).not.toMatch(/session/i);
  });

  it("treats any other code as a lost connection that may be retried", () => {
    for (const code of [1000, 1001, 1006, 1009, 4999]) {
      expect(closeReasonOf(code)).toMatchObject({ code, retry: true });
    }
  });

  it("permits no retry when the same connection can never succeed", () => {
    const final = Object.values(closeReasons).filter(({ retry }) => !retry);
    expect(final.map(({ code }) => code)).toEqual([4401, 4403, 4404, 4409, 4410]);
  });
});
