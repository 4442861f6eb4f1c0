import { menuActions } from "@corridor/program";
import { plainActions } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import type { ChallengeDocument } from "./challenge-document.ts";
import { rightsOf } from "./rights.ts";

const allowing = (actions: ChallengeDocument["allowed"]["actions"]) =>
  rightsOf({
    allowed: { drivers: ["program"], lines: 4, conditions: null, actions, edits: [], maze: false },
  }).actions;

describe("the allowed actions of a challenge", () => {
  it("are the actions of the paper if the challenge lists none", () => {
    expect(allowing(null)).toEqual(plainActions.filter((each) => each !== "stop").toSorted(byMenu));
  });

  it("include stop if the challenge lists it", () => {
    expect(allowing(["stop", "forward"])).toEqual(["forward", "stop"]);
  });
});

it("the editor's menu contains every action that a program can use", () => {
  expect(menuActions.toSorted()).toEqual([...plainActions].toSorted());
});

function byMenu(a: (typeof plainActions)[number], b: (typeof plainActions)[number]): number {
  return menuActions.indexOf(a) - menuActions.indexOf(b);
}
