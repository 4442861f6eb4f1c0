/** The coach and the lessons agree: a solution is not doubted, a typical mistake is seen while it is made. */
import type { Attempt } from "@corridor/challenge";
import { adviseProgram } from "@corridor/coach";
import type { MazeDocument } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import { missions } from "../lessons/missions/missions.ts";
import { answers } from "../lessons/missions/testing/answers.ts";

/** Kinds of advice on an attempt, with the number of the line; none on one by hand. */
function adviceOn(attempt: Attempt, mazes: readonly MazeDocument[]): string[] {
  if (!("rules" in attempt)) return [];
  const kinds = mazes.flatMap((maze) =>
    adviseProgram(attempt, maze).map(({ line, kind }) =>
      line === "default" ? `otherwise ${kind}` : `${line + 1} ${kind}`,
    ),
  );
  return [...new Set(kinds)];
}

/** What this mission gives to begin with, and is about. */
const solutionsWith: Partial<Record<string, string[]>> = { "first-true-line": ["2 never-decides"] };

describe("advice on the missions", () => {
  it.each(missions)("doubts no solution of $id", ({ id, challenge }) => {
    expect(adviceOn(answers[id].solution, challenge.mazes)).toEqual(solutionsWith[id] ?? []);
  });

  it.each([
    ["side-opening", "1 immediate-into-opening"],
    ["no-room", "1 delayed-about-front"],
    ["faulty-line", "1 immediate-into-opening"],
    ["right-wall", "2 delayed-about-front"],
  ] as const)("sees the typical mistake of %s", (id, advice) => {
    const mission = missions.find((each) => each.id === id);
    const found = adviceOn(answers[id].wrong.attempt, mission?.challenge.mazes ?? []);
    expect(found).toContain(advice);
  });
});
