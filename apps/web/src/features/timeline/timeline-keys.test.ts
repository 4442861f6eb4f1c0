import { describe, expect, it } from "vitest";
import { timelineKey } from "./timeline-keys.ts";

describe("a key on the timeline", () => {
  it.each([
    ["ArrowLeft", { type: "seek-step", by: -1 }],
    ["ArrowDown", { type: "seek-step", by: -1 }],
    ["ArrowRight", { type: "seek-step", by: 1 }],
    ["ArrowUp", { type: "seek-step", by: 1 }],
    ["Home", { type: "seek", tick: 0 }],
    ["End", { type: "now" }],
    ["PageDown", { type: "seek", tick: 300 }],
    ["PageUp", { type: "seek", tick: 1_500 }],
    ["w", null],
    ["Enter", null],
    ["Tab", null],
  ])("%s asks for %o", (key, message) => {
    expect(timelineKey(key, 900, 2_400)).toEqual(message);
  });

  it("stops at the start and at now", () => {
    expect(timelineKey("PageDown", 200, 2_400)).toEqual({ type: "seek", tick: 0 });
    expect(timelineKey("PageUp", 1_800, 2_400)).toEqual({ type: "now" });
  });

  it.each(["ArrowRight", "ArrowUp"])(
    "%s does not let the program drive on from now where the task refuses it",
    (key) => {
      expect(timelineKey(key, 2_400, 2_400, false, true)).toBeNull();
      expect(timelineKey(key, 2_400, 2_400, true, true)).toBeNull();
      expect(timelineKey(key, 900, 2_400, false, true)).toEqual({ type: "seek-step", by: 1 });
      expect(timelineKey(key, 900, 2_400, true, true)).toEqual({ type: "seek", tick: 901 });
    },
  );
});
