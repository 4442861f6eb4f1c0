import { describe, expect, it } from "vitest";
import { afterDrag, afterPress } from "./sheet.ts";

describe("the phone's sheet", () => {
  it("goes through all positions by presses", () => {
    expect(afterPress("closed")).toBe("half");
    expect(afterPress("half")).toBe("open");
    expect(afterPress("open")).toBe("closed");
  });

  it.each([
    ["half", -100, "open"],
    ["half", 100, "closed"],
    ["open", 100, "half"],
    ["closed", -100, "half"],
    ["open", -100, "open"],
    ["closed", 100, "closed"],
    ["half", 10, "half"],
  ] as const)("from %s, a drag by %d px leads to %s", (from, by, to) => {
    expect(afterDrag(from, by)).toBe(to);
  });
});
