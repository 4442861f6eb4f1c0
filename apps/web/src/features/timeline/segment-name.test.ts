import { describe, expect, it } from "vitest";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import { fits, nameOf } from "./segment-name.ts";

const { t } = createI18n(en);

describe("a segment of the ribbon", () => {
  it.each([
    [0, "1"],
    ["me", "Me"],
    ["default", "otherwise"],
    ["mixed", null],
  ] as const)("of %s is called %s, and never by dots", (who, name) => {
    expect(nameOf(t, who)).toBe(name);
  });

  it("has its whole name or none", () => {
    expect(fits("otherwise", 90)).toBe(true);
    expect(fits("otherwise", 40)).toBe(false);
    expect(fits("それ以外", 60)).toBe(true);
    expect(fits("それ以外", 40)).toBe(false);
  });
});
