import type { Goal } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import { missions } from "./missions/missions.ts";
import { room, eastFrom } from "./missions/mission.ts";
import { handAdvice } from "./hand-advice.ts";

function missionOf(id: string): { goal: Goal; maze: MazeDocument } {
  const challenge = missions.find((each) => each.id === id)?.challenge;
  const maze = challenge?.mazes[0];
  if (challenge === undefined || maze === undefined) throw new Error(`no mission ${id}`);
  return { goal: challenge.goal, maze };
}

describe("mission 1: the goal is a square from 500 to 600 in a corridor from west to east", () => {
  const { goal, maze } = missionOf("make-it-move");

  it.each([
    { place: "before the goal", pose: { x: 300, y: 150, heading: 90 }, advice: "ahead" },
    { place: "half on the goal", pose: { x: 510, y: 150, heading: 90 }, advice: "ahead" },
    { place: "beyond the goal", pose: { x: 650, y: 150, heading: 90 }, advice: "behind" },
    {
      place: "before the goal, looking back",
      pose: { x: 300, y: 150, heading: 270 },
      advice: "behind",
    },
    {
      place: "beyond the goal, looking back",
      pose: { x: 650, y: 150, heading: 270 },
      advice: "ahead",
    },
    { place: "at a side wall", pose: { x: 300, y: 150, heading: 0 }, advice: "turn" },
    { place: "at a side wall, touching it", pose: { x: 300, y: 125, heading: 0 }, advice: "turn" },
    { place: "a little askew", pose: { x: 450, y: 150, heading: 95 }, advice: "ahead" },
    {
      place: "so askew that it meets the wall first",
      pose: { x: 250, y: 150, heading: 110 },
      advice: "turn",
    },
    {
      place: "along a wall that it touches",
      pose: { x: 300, y: 125, heading: 90 },
      advice: "ahead",
    },
  ])("$place: $advice", ({ pose, advice }) => {
    expect(handAdvice(goal, maze, pose)).toBe(advice);
  });
});

describe("mission 2: front reads 130 to 170 cm in a corridor from 100 to 800", () => {
  const { goal, maze } = missionOf("how-far");

  it.each([
    { place: "far from the wall", pose: { x: 300, y: 150, heading: 90 }, advice: "ahead" },
    { place: "too near to the wall", pose: { x: 750, y: 150, heading: 90 }, advice: "behind" },
    { place: "at the wall, touching it", pose: { x: 775, y: 150, heading: 90 }, advice: "behind" },
    {
      place: "turned round, at the wall",
      pose: { x: 125, y: 150, heading: 270 },
      advice: "behind",
    },
    { place: "at a side wall", pose: { x: 300, y: 150, heading: 0 }, advice: "turn" },
    { place: "at the other side wall", pose: { x: 300, y: 150, heading: 180 }, advice: "turn" },
    { place: "aslant in the corridor", pose: { x: 300, y: 150, heading: 45 }, advice: "turn" },
  ])("$place: $advice", ({ pose, advice }) => {
    expect(handAdvice(goal, maze, pose)).toBe(advice);
  });
});

describe("a goal that no straight drive reaches", () => {
  const around = room(["#####", "#...#", "###.#", "#####"], eastFrom(1, 1), { column: 3, row: 2 });

  it("asks for no turn, because none helps from here", () => {
    expect(handAdvice({ kind: "reach" }, around, { x: 150, y: 150, heading: 90 })).toBe("far");
    expect(handAdvice({ kind: "reach" }, around, { x: 350, y: 150, heading: 90 })).toBe("turn");
  });

  it("is a reading that is longer than any path", () => {
    const goal: Goal = { kind: "stop", sensor: "back", from: 900, to: 950 };
    expect(handAdvice(goal, around, { x: 150, y: 150, heading: 90 })).toBe("far");
  });
});

describe("a reading of a side sensor", () => {
  const { maze } = missionOf("side-opening");
  const goal: Goal = { kind: "stop", sensor: "right", from: 200, to: 400 };

  it.each([
    { place: "before the opening", pose: { x: 150, y: 150, heading: 90 }, advice: "ahead" },
    { place: "beyond the opening", pose: { x: 500, y: 150, heading: 90 }, advice: "behind" },
  ])("$place: $advice", ({ pose, advice }) => {
    expect(handAdvice(goal, maze, pose)).toBe(advice);
  });
});
