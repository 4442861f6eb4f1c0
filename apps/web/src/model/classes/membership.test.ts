import type { JoinedClass } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { VolatileStorage } from "../storage/volatile-storage.ts";
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

  it("is none if another version stored it", () => {
    const tab = new VolatileStorage();
    tab.setItem("corridor.class", '{"class":1}');
    expect(storedMembership(tab)).toBeNull();
  });
});
