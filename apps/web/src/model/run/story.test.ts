import { describe, expect, it } from "vitest";
import type { RunEvent } from "../../simulator/protocol/worker-messages.ts";
import { storyOf } from "./story.ts";

const bump: RunEvent = {
  kind: "bump",
  tick: 786,
  pose: { x: 448, y: 326, heading: 0 },
  line: 2,
  driver: "program",
  bumps: 1,
  cause: null,
  diagnosis: null,
  program: null,
};

describe("storyOf", () => {
  it("states time, tick and square of a bump, and blames no line for it", () => {
    expect(storyOf(bump)).toEqual({
      kind: "bump",
      teller: "program",
      line: 0,
      seconds: "13.1",
      after: 786,
      tick: 786,
      column: 5,
      row: 4,
    });
  });

  it("names the line that reached the goal as its badge has it", () => {
    expect(storyOf({ ...bump, kind: "goal" })).toMatchObject({ teller: "line", line: 3 });
    const byOtherwise = storyOf({ ...bump, kind: "goal", line: "default" });
    expect(byOtherwise).toMatchObject({ teller: "otherwise", line: 0 });
  });

  it.each([
    { name: "a hand", changes: { line: null, driver: "me" as const }, teller: "me" },
    { name: "a script", changes: { line: null, driver: "remote" as const }, teller: "remote" },
  ])("names $name where no numbered line drove", ({ changes, teller }) => {
    expect(storyOf({ ...bump, ...changes }).teller).toBe(teller);
  });

  it("counts a script's driving, and not its waiting, as the clock does", () => {
    const goal = { ...bump, kind: "goal" as const, driver: "remote" as const, tick: 900 };
    expect(storyOf(goal, 300)).toMatchObject({ seconds: "10.0", tick: 900 });
    expect(storyOf({ ...goal, kind: "bump" }, 300).seconds).toBe("10.0");
  });
});
