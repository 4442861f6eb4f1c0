/**
 * The coach and the lessons agree. A mission's own program and a solution get no advice, typical
 * mistakes get advice during editing, and no fix leads away from the goal.
 */
import { checkChallenge, lessonOf, rightsOf, type ChallengeDocument } from "@corridor/challenge";
import { adviseProgram, applyFix, type Advice } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { challengeOf } from "../lessons/missions/mission.ts";
import { missions } from "../lessons/missions/missions.ts";
import { answers } from "../lessons/missions/testing/answers.ts";
import { concernsReader } from "./advice-in-challenge.ts";

const words = { task: "Task", short: "Task", hints: [] };
const all = missions.map((mission) => ({
  id: mission.id,
  challenge: challengeOf(mission, "Mission", words),
}));

/** The advice that a student sees in all mazes of the mission. */
function shownAdvice(program: ProgramDocument, challenge: ChallengeDocument): Advice[] {
  const rights = rightsOf(challenge);
  return challenge.mazes
    .flatMap((maze) => adviseProgram(program, maze))
    .filter((advice) =>
      concernsReader(advice, program, { lesson: lessonOf(challenge), index: 0, rights }),
    );
}

function kindsOf(advice: readonly Advice[]): string[] {
  const kinds = advice.map(({ line, kind }) => `${line === "default" ? line : line + 1} ${kind}`);
  return [...new Set(kinds)];
}

/**
 * The progress of a program: the mazes passed, and the cells visited in all mazes before it failed.
 */
function progress(challenge: ChallengeDocument, program: ProgramDocument): [number, number] {
  const { mazes } = checkChallenge(challenge, program);
  const passed = mazes.filter(({ failure }) => failure === null).length;
  return [passed, mazes.reduce((sum, { visited }) => sum + visited, 0)];
}

describe("advice on the missions", () => {
  it.each(all)("is none on what $id gives", ({ challenge }) => {
    const { program } = challenge;
    if (program === null) throw new Error("every mission begins with a program");
    expect(kindsOf(shownAdvice(program, challenge))).toEqual([]);
  });

  it.each(all)("is not given on a solution of $id", ({ id, challenge }) => {
    const { solution } = answers[id];
    if (!("rules" in solution)) return;
    expect(kindsOf(shownAdvice(solution, challenge))).toEqual([]);
  });

  it.each([
    ["side-opening", "1 immediate-into-opening"],
    ["no-room", "1 delayed-about-front"],
    ["faulty-line", "1 immediate-into-opening"],
    ["right-wall", "2 delayed-about-front"],
  ] as const)("finds the typical mistake of %s", (id, advice) => {
    const found = all.find((each) => each.id === id);
    const { attempt } = answers[id].wrong;
    if (found === undefined || !("rules" in attempt)) throw new Error(`no program for ${id}`);
    expect(kindsOf(shownAdvice(attempt, found.challenge))).toContain(advice);
  });

  it.each(all)("never leads away from the goal of $id", ({ id, challenge }) => {
    const programs = [answers[id].wrong.attempt, challenge.program].filter(
      (each): each is ProgramDocument => each !== null && "rules" in each,
    );
    const astray = programs.flatMap((program) => {
      const [passed, seen] = progress(challenge, program);
      const fixes = challenge.mazes.flatMap((maze) =>
        adviseProgram(program, maze).flatMap(({ fix }) => (fix === null ? [] : [fix])),
      );
      return fixes.filter((fix) => {
        const [nowPassed, nowSeen] = progress(challenge, applyFix(program, fix));
        // A program that passes need not visit every cell.
        return nowPassed < passed || (nowPassed === passed && nowSeen < seen);
      });
    });
    expect(astray.filter(({ kind }) => kind !== "delete")).toEqual([]);
  });

  it("turns back where both sides are taken by the lines above, as in the mission of the faulty line", () => {
    const found = all.find(({ id }) => id === "faulty-line");
    const [maze] = found?.challenge.mazes ?? [];
    const program = found?.challenge.program;
    if (found === undefined || maze === undefined || !program) throw new Error("no such mission");
    const [advice] = adviseProgram(program, maze);
    if (!advice?.fix) throw new Error("no fix");
    expect(advice.fix).toEqual({ kind: "action", line: 2, action: "turn 180" });
    expect(checkChallenge(found.challenge, applyFix(program, advice.fix)).passed).toBe(true);
  });
});
