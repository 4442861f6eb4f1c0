import { menuActions } from "@corridor/program";
import { plainActions } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import type { ChallengeDocument } from "./challenge-document.ts";
import { rightsOf } from "./rights.ts";

const allowing = (actions: ChallengeDocument["allowed"]["actions"]) =>
  rightsOf({
    allowed: { drivers: ["program"], lines: 4, conditions: null, actions, edits: [], maze: false },
  }).actions;

describe("what a challenge offers", () => {
  it("is the paper's set of actions where it names none", () => {
    expect(allowing(null)).toEqual(plainActions.filter((each) => each !== "stop").toSorted(byMenu));
  });

  it("is stop too where it is named", () => {
    expect(allowing(["stop", "forward"])).toEqual(["forward", "stop"]);
  });
});

it("the menu of the editor has every action that a program may use", () => {
  expect(menuActions.toSorted()).toEqual([...plainActions].toSorted());
});

function byMenu(a: (typeof plainActions)[number], b: (typeof plainActions)[number]): number {
  return menuActions.indexOf(a) - menuActions.indexOf(b);
}
