import {
  checkChallenge,
  parseChallenge,
  type ChallengeDocument,
  type EditKind,
} from "@corridor/challenge";
import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import words from "../../../text/en/missions.json" with { type: "json" };
import { challengeOf, missionIds, type Mission, type MissionId } from "./mission.ts";
import { missions } from "./missions.ts";
import { answers, type Feedback } from "./testing/answers.ts";
import { studyMistakes } from "./testing/mistakes.ts";

function documentOf(mission: Mission): ChallengeDocument {
  const { name, task, short, hints } = words.missions[mission.id];
  return challengeOf(mission, name, { task, short, hints: Object.values(hints) });
}

describe("the path of missions", () => {
  it("has them all once, in the order of their ids", () => {
    expect(missions.map(({ id }) => id)).toEqual(missionIds);
    expect(missions.length).toBeGreaterThanOrEqual(12);
  });
});

describe.each(missions.map((mission) => [mission.id, mission] as const))("%s", (id, mission) => {
  const challenge = documentOf(mission);

  it("is a legal challenge with 2 to 4 hints and a task of one or two sentences", () => {
    expect(parseChallenge(challenge)).toEqual({ ok: true, value: challenge });
    expect(challenge.words.hints.length).toBeGreaterThanOrEqual(2);
    expect(challenge.words.hints.length).toBeLessThanOrEqual(4);
    expect(challenge.words.task.match(/[.?]( |$)/g)?.length).toBeLessThanOrEqual(2);
  });

  it("is solved by its solution in every maze, within its par and well within a minute", () => {
    const { solution } = answers[id];
    const verdict = checkChallenge(challenge, solution);
    expect(verdict.failure).toBeNull();
    expect(verdict.passed).toBe(true);
    expect(verdict.mazes).toHaveLength(challenge.mazes.length);
    const ticks = Math.max(...verdict.mazes.map((each) => each.ticks));
    expect(ticks).toBeLessThanOrEqual((challenge.par?.seconds ?? 0) * 60);
    expect(ticks).toBeLessThan(30 * 60);
  });

  it("shows what failed in the typical wrong answer, with its line and numbers", () => {
    const { attempt, feedback } = answers[id].wrong;
    const { passed, failure } = checkChallenge(challenge, attempt);
    expect(passed).toBe(false);
    if (failure === null) throw new Error("no failure");
    const { code, maze, line, tick, decision } = failure;
    const found: Feedback = {
      code,
      maze,
      line,
      tick,
      needed: Math.round(failure.needed ?? 0),
      found: Math.round(failure.found ?? 0),
    };
    if (decision?.action) {
      found.decided = { action: decision.action, front: Math.round(decision.readings.front) };
    }
    expect(found).toEqual(feedback);
  });

  it("is not solved by what it begins with, unless pressing Run is the task", () => {
    const begun = challenge.program;
    if (begun === null) throw new Error("every mission begins with a program");
    expect(checkChallenge(challenge, begun).passed).toBe(id === "make-it-move");
  });
});

describe("what a mission leaves to the student", () => {
  const everything: EditKind[] = ["condition", "number", "action", "otherwise", "order", "lines"];
  /** The edits that the task requires, and no others. */
  const asked: Record<MissionId, EditKind[]> = {
    "make-it-move": [],
    "how-far": [],
    "one-line": ["action"],
    "first-true-line": ["order"],
    centimetres: ["number"],
    "own-line": everything,
    "side-opening": ["action"],
    "no-room": ["action"],
    "order-of-lines": ["order"],
    "faulty-line": ["action"],
    "right-wall": everything,
    "every-maze": everything,
    "left-or-right": ["action", "otherwise"],
    "farthest-distance": everything,
  };

  it.each(missions.map((mission) => [mission.id, mission] as const))(
    "%s: exactly what its task asks for",
    (id, { challenge: { allowed, mazes } }) => {
      expect(allowed.edits.toSorted()).toEqual(asked[id].toSorted());
      const { task, short } = words.missions[id];
      const limits = [...`${task} ${short}`.matchAll(/(\d+) lines?\b/g)].map(([, most]) =>
        Number(most),
      );
      expect(limits.filter((most) => most !== allowed.lines)).toEqual([]);
      const counts = [...`${task} ${short}`.matchAll(/(\d+) mazes\b/g)].map(([, most]) =>
        Number(most),
      );
      expect(counts.filter((most) => most !== mazes.length)).toEqual([]);
      expect(allowed.drivers[0]).toBe(allowed.lines === 0 ? "me" : "program");
    },
  );

  it("names no line by its number where only the order changes, because the numbers change", () => {
    const ordering = missionIds.filter((id) => asked[id].join() === "order");
    expect(ordering).toEqual(["first-true-line", "order-of-lines"]);
    for (const id of ordering) {
      const { task, short, hints } = words.missions[id];
      expect([task, short, ...Object.values(hints)].join(" ")).not.toMatch(/lines? \d/i);
    }
  });
});

describe("the mistakes of the study of 2013", () => {
  const page = readFileSync(new URL("../../../../../../docs/lessons.md", import.meta.url), "utf8");
  const rows = page
    .split("\n")
    .filter((text) => text.startsWith("|"))
    .map((text) => text.split("|").map((cell) => cell.trim()));

  it.each(studyMistakes)("$mistake: met by a mission, as docs/lessons.md says", (entry) => {
    expect(entry.missions.length).toBeGreaterThan(0);
    const row = rows.find((cells) => cells[1] === entry.mistake);
    const share = entry.students === null ? "" : `${((entry.students / 28) * 100).toFixed(1)} %`;
    expect(row?.[2]).toBe(share);
    const numbered = entry.missions.map((id) => `${missionIds.indexOf(id) + 1} \`${id}\``);
    expect(row?.[3]).toBe(numbered.join(", "));
  });

  it("names the maze that a program fails after it passed another", () => {
    for (const id of ["every-maze", "left-or-right"] as const) {
      const mission = missions.find((each) => each.id === id);
      if (mission === undefined) throw new Error(`no mission ${id}`);
      const { mazes } = checkChallenge(documentOf(mission), answers[id].wrong.attempt);
      expect(mazes[0]?.failure).toBeNull();
      expect(mazes.some(({ failure }) => failure !== null)).toBe(true);
    }
  });
});
