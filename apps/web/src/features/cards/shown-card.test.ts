import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { firstProgram } from "../../simulator/protocol/first-project.ts";
import type { RunEvent } from "../../simulator/protocol/worker-messages.ts";
import { shownCard } from "./shown-card.ts";

function explained(kind: RunEvent["kind"], tick: number) {
  const event: RunEvent = {
    kind,
    tick,
    pose: { x: 50, y: 50, heading: 0 },
    line: 0,
    driver: "program",
    bumps: 1,
    cause: null,
    diagnosis: null,
    program: null,
  };
  return { event, program: firstProgram, diagnosis: null };
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
    const snapshot = snapshotOf({ driver: "program", tick, state, goalReached: false });
    expect(shownCard({ bump, goal: null }, snapshot, view)).toBe(card);
  });

  it.each([
    { name: "the goal, where the program paused", tick: 300, state: "paused", card: "goal" },
    { name: "the goal, after a hand let go", tick: 340, state: "paused", card: "goal" },
    { name: "nothing while a hand drives on", tick: 340, state: "running", card: null },
  ] as const)("is $name", ({ tick, state, card }) => {
    const snapshot = snapshotOf({ driver: "program", tick, state, goalReached: true });
    expect(shownCard({ bump, goal }, snapshot, "now")).toBe(card);
  });

  it("is the bump of a robot that drove on from the goal into a wall, and the goal after it", () => {
    const later = explained("bump", 350);
    const at = (tick: number) =>
      snapshotOf({ driver: "program", tick, state: "paused", goalReached: true });
    expect(shownCard({ bump: later, goal }, at(350), "now")).toBe("bump");
    expect(shownCard({ bump: later, goal }, at(360), "now")).toBe("goal");
  });

  const met = {
    state: "met",
    driver: "program",
    ticks: 300,
    bumps: 0,
    lines: 1,
  } as const;

  it.each([
    {
      name: "that it is met, where the run did it",
      result: met,
      isSeen: true,
      tick: 300,
      card: "met",
    },
    { name: "nothing of it before that", result: met, isSeen: true, tick: 299, card: null },
    {
      name: "that it is met by a check, wherever the robot stands",
      result: met,
      isSeen: false,
      tick: 0,
      card: "met",
    },
    {
      name: "the goal of one maze, while others wait for the check",
      result: { state: "here", driver: "program", ticks: 300, bumps: 0, lines: 1 },
      isSeen: false,
      tick: 300,
      card: "goal",
    },
    {
      name: "nothing at a goal that was reached against the rules",
      result: { state: "failed", code: "bump", tick: 100 },
      isSeen: true,
      tick: 300,
      card: null,
    },
  ] as const)("of a challenge is $name", ({ result, isSeen, tick, card }) => {
    const snapshot = snapshotOf({ tick, state: "paused", goalReached: tick >= 300 });
    expect(shownCard({ bump: null, goal }, snapshot, "now", { result, isSeen })).toBe(card);
  });

  describe("of a script", () => {
    const atRest = { driver: "remote", state: "running", command: null, motion: "stop" } as const;
    const its = { ...bump, event: { ...bump.event, driver: "remote" as const, line: null } };

    it("is the bump while the robot rests at the wall, though time goes on", () => {
      const snapshot = snapshotOf({ ...atRest, tick: 160, bumping: true, bumps: 1 });
      expect(shownCard({ bump: its, goal: null }, snapshot, "now")).toBe("bump");
    });

    it("is nothing once the next command runs, or the robot has left the wall", () => {
      const busy = snapshotOf({ ...atRest, command: 4, motion: "move", bumping: true, bumps: 1 });
      expect(shownCard({ bump: its, goal: null }, busy, "now")).toBeNull();
      const free = snapshotOf({ ...atRest, bumping: false, bumps: 1 });
      expect(shownCard({ bump: its, goal: null }, free, "now")).toBeNull();
    });

    it("is the goal while the robot rests there", () => {
      const snapshot = snapshotOf({ ...atRest, tick: 320, goalReached: true });
      expect(shownCard({ bump: null, goal }, snapshot, "now")).toBe("goal");
    });
  });

  it("is nothing before the first frame", () => {
    expect(shownCard({ bump, goal }, null, "now")).toBeNull();
  });
});
