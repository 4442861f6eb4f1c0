import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { firstProgram } from "../../app/first-visit.ts";
import type { Moment } from "../../worker/worker-messages.ts";
import { shownCard } from "./shown-card.ts";

function explained(kind: Moment["kind"], tick: number) {
  const moment: Moment = {
    kind,
    tick,
    pose: { x: 50, y: 50, heading: 0 },
    line: 0,
    driver: "program",
    bumps: 1,
    cause: null,
    mends: null,
  };
  return { moment, program: firstProgram, mends: [] };
}

const bump = explained("bump", 100);
const goal = explained("goal", 300);

describe("shownCard", () => {
  it.each([
    { name: "the bump, at its moment", tick: 100, state: "paused", view: "now", card: "bump" },
    { name: "the bump, gone back to", tick: 100, state: "paused", view: "past", card: "bump" },
    { name: "nothing a tick later", tick: 101, state: "paused", view: "past", card: null },
    {
      name: "nothing while it is watched",
      tick: 100,
      state: "running",
      view: "playing",
      card: null,
    },
    {
      name: "nothing while the robot drives on",
      tick: 100,
      state: "running",
      view: "now",
      card: null,
    },
  ] as const)("is $name", ({ tick, state, view, card }) => {
    const snapshot = snapshotOf({ tick, state, goalReached: false });
    expect(shownCard({ bump, goal: null }, snapshot, view)).toBe(card);
  });

  it.each([
    { name: "the goal, where the program paused", tick: 300, state: "paused", card: "goal" },
    { name: "the goal, after a hand let go", tick: 340, state: "paused", card: "goal" },
    { name: "nothing while a hand drives on", tick: 340, state: "running", card: null },
  ] as const)("is $name", ({ tick, state, card }) => {
    const snapshot = snapshotOf({ tick, state, goalReached: true });
    expect(shownCard({ bump, goal }, snapshot, "now")).toBe(card);
  });

  it("is nothing before the first frame", () => {
    expect(shownCard({ bump, goal }, null, "now")).toBeNull();
  });
});
