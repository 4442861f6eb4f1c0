import { describe, expect, it } from "vitest";
import { firstProgram } from "../../simulator/protocol/first-project.ts";
import { runEventAt } from "../../simulator/worker/testing/run-event-at.ts";
import type { RunEvent } from "../../simulator/protocol/worker-messages.ts";
import { createCardStore, explain, truncateCards } from "./card-store.ts";

function eventOf(kind: RunEvent["kind"], tick: number): RunEvent {
  return runEventAt(kind, tick, firstProgram);
}

describe("explanations of a run", () => {
  it.each([
    { name: "is retained if the run continues after it", after: 400, left: [316, 400] },
    { name: "is discarded if the run continues differently before it", after: 350, left: [316] },
    { name: "is discarded altogether in another run", after: -1, left: [] },
  ])("$name", ({ after, left }) => {
    const cards = createCardStore();
    explain(cards, eventOf("bump", 316), firstProgram);
    explain(cards, eventOf("goal", 400), firstProgram);
    truncateCards(cards, after);
    const { bump, goal } = cards.getState();
    expect([bump, goal].flatMap((each) => each?.event.tick ?? [])).toEqual(left);
  });

  it.each(["bump", "goal"] as const)(
    "is of the program that drove, not of one edited at the same time: %s",
    (kind) => {
      const cards = createCardStore();
      const edited = { ...firstProgram, rules: firstProgram.rules.slice(1) };
      explain(cards, eventOf(kind, 316), edited);
      expect(cards.getState()[kind]?.program).toEqual(firstProgram);
      // The page's own object, whose identity shows that the program was not edited since.
      const same = structuredClone(firstProgram);
      explain(cards, eventOf(kind, 317), same);
      expect(cards.getState()[kind]?.program).toBe(same);
    },
  );
});
