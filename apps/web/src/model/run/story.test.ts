import { beforeAll, describe, expect, it } from "vitest";
import type { RunEvent } from "../../simulator/protocol/worker-messages.ts";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import { storyOf, storyText } from "./story.ts";

const words = createI18n(en);
const { t } = words;
beforeAll(() => words.loadNamespaces("runDetails"));

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

  it("states the time of a long run as the timeline does", () => {
    expect(storyText(t, storyOf({ ...bump, tick: 7386 }), "en")).toContain(
      "at 2 min 3.1 s (tick 7386)",
    );
  });

  it("counts a script's driving, and not its waiting, as the clock does", () => {
    const goal = { ...bump, line: null, driver: "remote" as const, tick: 900 };
    const textOf = (kind: "goal" | "bump") => storyText(t, storyOf({ ...goal, kind }, 300), "en");
    expect(textOf("goal")).toBe("Goal reached after 10.0 s, in row 4, column 5, by the script.");
    expect(textOf("bump")).toMatch(/^Bump: the script drove into a block at 10\.0 s\. /);
  });
});
