import type { JoinedClass } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { VolatileStorage } from "../storage/volatile-storage.ts";
import { REPORTED_KEY } from "./stored-keys.ts";
import { removeMembership, storedMembership, storeMembership } from "./membership.ts";

const joined: JoinedClass = {
  class: "A".repeat(22),
  student: 1,
  name: { word: 7, text: null },
  key: `stu_${"B".repeat(22)}`,
};

describe("the class of a tab", () => {
  it("survives a reload", () => {
    const tab = new VolatileStorage();
    expect(storedMembership(tab)).toBeNull();
    storeMembership(tab, joined);
    expect(storedMembership(tab)).toEqual(joined);
  });

  it("is none after the student has left", () => {
    const tab = new VolatileStorage();
    storeMembership(tab, joined);
    removeMembership(tab);
    expect(storedMembership(tab)).toBeNull();
  });

  it("starts with nothing of the class that the tab had joined before", () => {
    const tab = new VolatileStorage();
    storeMembership(tab, joined);
    tab.setItem(REPORTED_KEY, "what was reported");
    storeMembership(tab, { ...joined, name: { word: 8, text: null } });
    expect(tab.getItem(REPORTED_KEY)).toBe("what was reported");
    storeMembership(tab, { ...joined, class: "C".repeat(22), key: `stu_${"D".repeat(22)}` });
    expect(tab.getItem(REPORTED_KEY)).toBeNull();
  });

  it("is none if another version stored it", () => {
    const tab = new VolatileStorage();
    tab.setItem("corridor.class", '{"class":1}');
    expect(storedMembership(tab)).toBeNull();
  });
});
