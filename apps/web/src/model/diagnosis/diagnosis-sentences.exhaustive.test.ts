/** Checks every sentence that a student reads about a failed run against the run itself. */
import { taskOf } from "@corridor/challenge";
import { diagnoseFreePlay } from "@corridor/coach";
import { generateMaze, type MazeDocument } from "@corridor/maze";
import type { Condition, ProgramDocument } from "@corridor/program";
import { plainActions, type PlainAction, type SensorName } from "@corridor/protocol";
import { Simulation } from "@corridor/simulation";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { checkProgram } from "../lessons/testing/check-program.ts";
import { plain, words } from "../lessons/testing/mission-words.ts";
import { failureText } from "../lessons/failure-text.ts";
import { lines } from "../lessons/missions/mission.ts";
import { missions } from "../lessons/missions/missions.ts";
import { solved } from "../lessons/missions/testing/causes.ts";
import type { WrongAnswer } from "../lessons/missions/testing/wrong-answers.ts";
import { diagnosisText, diagnosisWords } from "./diagnosis-text.ts";
import { falseSentences } from "./testing/sentence-claims.ts";

/** A solution with another condition in one line. */
function changed(id: string, line: number, when: Condition): WrongAnswer {
  const mission = solved.find((each) => each.id === id);
  const rule = mission?.solution.rules[line];
  if (mission === undefined || rule === undefined) throw new Error("no such line");
  const rules = mission.solution.rules.with(line, { ...rule, when });
  const { challenge, solution } = mission;
  return { name: id, line, challenge, program: { ...solution, rules } };
}

const number = (sensor: SensorName, is: "<" | ">", than: number): Condition => ({
  sensor,
  is,
  than,
});

describe("a number that is wrong", () => {
  it.each([
    {
      why: "decides too early",
      answer: changed("centimetres", 0, number("back", ">", 400)),
      says: "Line 1 chose “left 90” at 3.5 s, when back was 400.01 cm. That was about 50 cm too early.",
    },
    {
      why: "decides too early from the start on: the way from there counts, not the two numbers",
      answer: changed("own-line", 0, number("front", "<", 500)),
      says: "Line 1 chose “right 90” at 0.0 s, when front was 450 cm. That was about 400 cm too early.",
    },
    {
      why: "asks a little too little of a side, where no place is nearer by that much",
      answer: changed("every-maze", 0, number("right", ">", 50)),
      says: "Line 1 was true at 5.2 s, when right was 50.01 cm. Its number is off by about 10 cm.",
    },
    {
      why: "stops being true too early",
      answer: changed("farthest-distance", 0, number("front", ">", 150)),
      says: "Line 1 was no longer true at 3.0 s, when front was 150 cm. It stopped being true about 100 cm too early.",
    },
    {
      why: "is true while the robot turns, but never decides",
      answer: changed("right-wall", 0, number("right", ">", 250)),
      says: "Line 1 never decided. It was needed at 1.5 s, when right was 250 cm.",
    },
    {
      why: "is no matter of its size where the line asks the wrong side",
      answer: changed("every-maze", 0, number("left", ">", 60)),
      says: "Line 1 uses left. Another sensor is needed at 3.5 s (front: 100 cm, left: 250 cm, right: 50 cm).",
    },
  ])("$why", ({ answer, says }) => {
    const { verdict, diagnoses } = checkProgram({
      task: taskOf(answer.challenge),
      program: answer.program,
    });
    const { failure } = verdict;
    if (failure === null) throw new Error("no failure");
    const diagnosis = diagnoses[failure.maze ?? -1] ?? null;
    expect(plain(failureText(words, answer.challenge, failure, diagnosis))).toContain(says);
  });

  it("stays true for too long", () => {
    const maze = missions.find(({ id }) => id === "centimetres")?.challenge.mazes[0];
    if (maze === undefined) throw new Error("no maze");
    const program = lines("left 90", { when: number("back", "<", 550), do: "forward" });
    const state = new Simulation(maze).save();
    const found = diagnoseFreePlay({ maze, program, state }, 60 * 60);
    if (found === null) throw new Error("no failure");
    const text = plain(diagnosisText(diagnosisWords(words.t, "en"), found));
    expect(text).toMatch(/Line 1 was still true at .+ It was true for about \d+ cm too long\.$/u);
    expect(falseSentences(maze, program, text, found.event.tick)).toEqual([]);
  });
});

describe("a corner", () => {
  it.each([
    { than: 490, isBesideBeam: true },
    { than: 500, isBesideBeam: false },
  ])(
    "is named only where the beam passes it: $isBesideBeam after $than cm",
    ({ than, isBesideBeam }) => {
      const answer = changed("centimetres", 0, number("back", ">", than));
      const { verdict, diagnoses } = checkProgram({
        task: taskOf(answer.challenge),
        program: answer.program,
      });
      if (verdict.failure === null) throw new Error("no failure");
      const text = failureText(words, answer.challenge, verdict.failure, diagnoses[0] ?? null);
      expect(text.includes("The robot touched the corner of a block.")).toBe(isBesideBeam);
    },
  );
});

describe("a comparison of left with right", () => {
  it("is read on both sides where its sign is wrong", () => {
    const answer = changed("farthest-distance", 1, {
      sensor: "left",
      is: "<",
      than: "right",
      plus: 1,
    });
    const { verdict, diagnoses } = checkProgram({
      task: taskOf(answer.challenge),
      program: answer.program,
    });
    const { failure } = verdict;
    if (failure === null) throw new Error("no failure");
    expect(plain(failureText(words, answer.challenge, failure, diagnoses[0] ?? null))).toContain(
      "Line 2 was not true at 4.0 s (left: 250 cm, right: 150 cm). Its sign, “<”, points the wrong way.",
    );
  });
});

describe("a line that turns well at one place and to a wall at the next", () => {
  it("is named for its turn to the wall", () => {
    const mission = solved.find(({ id }) => id === "farthest-distance");
    if (mission === undefined) throw new Error("no mission");
    const { challenge } = mission;
    const program = lines("forward", { when: number("front", "<", 50), do: "left 90" });
    const { verdict, diagnoses } = checkProgram({ task: taskOf(challenge), program });
    const { failure } = verdict;
    if (failure === null) throw new Error("no failure");
    expect(plain(failureText(words, challenge, failure, diagnoses[0] ?? null))).toContain(
      "Line 1 chose “left 90” at 6.6 s and turned to a wall (left: 50 cm). There was room on another side (right: 250 cm).",
    );
  });
});

describe("two lines that undo each other", () => {
  it("are both named, although a line above them also drives forward", () => {
    const maze: MazeDocument = {
      format: "corridor/maze",
      version: 1,
      name: "",
      blocks: ["#####", "#.#.#", "#.#.#", "#...#", "#####"],
      start: { column: 1, row: 1, heading: "south" },
      goals: [{ column: 3, row: 1 }],
    };
    const program = lines(
      "forward",
      { when: { sensor: "left", is: ">", than: "right", plus: 50 }, do: "forward" },
      { when: number("front", ">", 125), do: "forward" },
      { when: number("right", "<", 75), do: "reverse" },
    );
    const state = new Simulation(maze).save();
    const found = diagnoseFreePlay({ maze, program, state }, 60 * 60);
    if (found === null) throw new Error("no failure");
    expect(plain(diagnosisText(diagnosisWords(words.t, "en"), found))).toContain(
      "Line 3 drives back and line 2 drives forward, again and again.",
    );
  });
});

const anyCondition: fc.Arbitrary<Condition> = fc.oneof(
  fc.record({
    sensor: fc.constantFrom("front" as const, "back" as const, "left" as const, "right" as const),
    is: fc.constantFrom("<" as const, ">" as const),
    than: fc.constantFrom(4, 30, 50, 60, 75, 100, 125, 150, 250),
  }),
  fc.record({
    sensor: fc.constant("left" as const),
    is: fc.constantFrom("<" as const, ">" as const),
    than: fc.constant("right" as const),
    plus: fc.constantFrom(-50, 0, 1, 50),
  }),
);
const anyProgram: fc.Arbitrary<ProgramDocument> = fc.record({
  format: fc.constant("corridor/program" as const),
  version: fc.constant(1 as const),
  name: fc.constant(""),
  default: fc.constantFrom<PlainAction>("forward", "forward", "left 90", "right 90"),
  rules: fc.array(fc.record({ when: anyCondition, do: fc.constantFrom(...plainActions) }), {
    minLength: 1,
    maxLength: 4,
  }),
});
const mazesOf = (kind: "tree" | "loops" | "rooms"): fc.Arbitrary<MazeDocument> =>
  fc
    .record({ side: fc.constantFrom(5, 7, 9), seed: fc.integer({ min: 0, max: 10_000 }) })
    .map(({ side, seed }) => generateMaze({ kind, columns: side, rows: side, seed, name: "" }));

describe("the texts of free play about any program in any maze are true of its run", () => {
  it.each(["tree", "loops", "rooms"] as const)("in every sentence (%s)", (kind) => {
    fc.assert(
      fc.property(mazesOf(kind), anyProgram, (maze, program) => {
        const state = new Simulation(maze).save();
        const found = diagnoseFreePlay({ maze, program, state }, 60 * 60);
        if (found === null) return;
        const text = plain(diagnosisText(diagnosisWords(words.t, "en"), found));
        expect(falseSentences(maze, program, text, found.event.tick)).toEqual([]);
      }),
      { numRuns: 70 },
    );
  });
});
