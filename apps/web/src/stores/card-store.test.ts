import { describe, expect, it } from "vitest";
import { firstProgram } from "../worker/first-work.ts";
import { momentAt } from "../worker/testing/moment-at.ts";
import type { Moment } from "../worker/worker-messages.ts";
import { createCardStore, explain, forgetAfter } from "./card-store.ts";

function moment(kind: Moment["kind"], tick: number): Moment {
  return momentAt(kind, tick, firstProgram);
}

describe("what was explained of a run", () => {
  it.each([
    { name: "is kept where the run goes on after it", after: 400, left: [316, 400] },
    { name: "is forgotten from where the run goes on in another way", after: 350, left: [316] },
    { name: "is forgotten altogether in another run", after: -1, left: [] },
  ])("$name", ({ after, left }) => {
    const cards = createCardStore();
    explain(cards, moment("bump", 316), firstProgram);
    explain(cards, moment("goal", 400), firstProgram);
    forgetAfter(cards, after);
    const { bump, goal } = cards.getState();
    expect([bump, goal].flatMap((each) => each?.moment.tick ?? [])).toEqual(left);
  });

  it.each(["bump", "goal"] as const)(
    "is of the program that drove, not of one edited in the same moment: %s",
    (kind) => {
      const cards = createCardStore();
      const edited = { ...firstProgram, rules: firstProgram.rules.slice(1) };
      explain(cards, moment(kind, 316), edited);
      expect(cards.getState()[kind]?.program).toEqual(firstProgram);
      // The page's own object, by which everybody sees that it was not edited since.
      const same = structuredClone(firstProgram);
      explain(cards, moment(kind, 317), same);
      expect(cards.getState()[kind]?.program).toBe(same);
    },
  );
});
