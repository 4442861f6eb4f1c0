import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { decidingLine, isPassedOver, shownTruth } from "./line-state.ts";

const snapshot = snapshotOf({
  driver: "program",
  sensors: { front: 40, right: 250, back: 50, left: 50 },
  motion: "forward",
  line: 0,
});

describe("decidingLine", () => {
  it("is the line that drives", () => {
    expect(decidingLine(snapshot)).toBe(0);
    expect(decidingLine({ ...snapshot, line: "default" })).toBe("default");
  });

  it.each(["me", "remote"] as const)("is none while %s drives", (driver) => {
    expect(decidingLine({ ...snapshot, driver })).toBeNull();
  });

  it("is none before the first snapshot", () => {
    expect(decidingLine(null)).toBeNull();
  });
});

describe("isPassedOver", () => {
  it("is so for all lines below the deciding one, and only for them", () => {
    expect([0, 1, 2].map((index) => isPassedOver(index, 1))).toEqual([false, false, true]);
  });

  it("is so for no line when otherwise decides, or nobody", () => {
    expect(isPassedOver(2, "default")).toBe(false);
    expect(isPassedOver(2, null)).toBe(false);
  });
});

describe("shownTruth", () => {
  it("is told of every condition, whoever drives", () => {
    const condition = { sensor: "right", is: ">", than: 60 } as const;
    const truth = { isTrue: true, left: "250", right: "> 60" };
    expect(shownTruth(condition, snapshot)).toEqual(truth);
    expect(shownTruth(condition, { ...snapshot, driver: "me", line: null })).toEqual(truth);
  });

  it("is none for a line that does nothing, and before the first snapshot", () => {
    expect(shownTruth(null, snapshot)).toBeNull();
    expect(shownTruth({ sensor: "right", is: ">", than: 60 }, null)).toBeNull();
  });
});
