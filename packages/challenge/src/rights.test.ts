import { menuActions } from "@corridor/program";
import { plainActions } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import type { ChallengeDocument } from "./challenge-document.ts";
import { helpKinds, toolNames } from "./challenge-limits.ts";
import type { LessonTask } from "./lesson-document.ts";
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

describe("tools and help", () => {
  const allowed: LessonTask["allowed"] = {
    drivers: ["remote", "me"],
    lines: 4,
    conditions: null,
    actions: null,
    edits: [],
    maze: false,
    tools: null,
    help: null,
  };

  it("are shown unless a task lists them, except the changes that fix a program", () => {
    expect([...rightsOf({ allowed }).tools]).toEqual(toolNames);
    expect([...rightsOf({ allowed }).help]).toEqual(helpKinds.filter((each) => each !== "fixes"));
    const { tools: _tools, help: _help, ...plain } = allowed;
    expect(rightsOf({ allowed: plain })).toEqual(rightsOf({ allowed }));
  });

  it("are only those that a task lists", () => {
    const { tools, help } = rightsOf({
      allowed: { ...allowed, tools: ["speed"], help: ["fixes"] },
    });
    expect([...tools]).toEqual(["speed"]);
    expect([...help]).toEqual(["fixes"]);
  });

  it("leave no driver Remote where the page hides Remote", () => {
    expect(rightsOf({ allowed }).drivers).toEqual(["remote", "me"]);
    expect(rightsOf({ allowed: { ...allowed, tools: ["share"] } }).drivers).toEqual(["me"]);
  });

  it("hide Remote where no script may drive", () => {
    const { tools } = rightsOf({ allowed: { ...allowed, drivers: ["program", "me"] } });
    expect([...tools]).toEqual(toolNames.filter((tool) => tool !== "remote"));
  });

  it("show Remote if it is the only driver", () => {
    const { drivers, tools } = rightsOf({
      allowed: { ...allowed, drivers: ["remote"], tools: [] },
    });
    expect(drivers).toEqual(["remote"]);
    expect([...tools]).toEqual(["remote"]);
  });
});

it("the editor's menu contains every action that a program can use", () => {
  expect(menuActions.toSorted()).toEqual([...plainActions].toSorted());
});

function byMenu(a: (typeof plainActions)[number], b: (typeof plainActions)[number]): number {
  return menuActions.indexOf(a) - menuActions.indexOf(b);
}
