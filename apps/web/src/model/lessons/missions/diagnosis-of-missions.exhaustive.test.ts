/**
 * Every wrong answer to a mission gets one cause. The diagnosis names a line only where changing it
 * can help.
 */
import { checkChallenge, findViolation, taskOf, type ChallengeDocument } from "@corridor/challenge";
import { causeLine, type Diagnosis } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { checkProgram } from "../testing/check-program.ts";
import { lines } from "./mission.ts";
import { causes, solved } from "./testing/causes.ts";
import {
  oneStepAnswers,
  oneStepFrom,
  twoStepAnswers,
  type WrongAnswer,
} from "./testing/wrong-answers.ts";

const oneStep = solved.map(({ id, challenge, solution }) => ({
  id,
  wrong: [...oneStepAnswers(challenge, solution)],
}));

/**
 * Pairs of changes that fix a mistake equally well, so that the diagnosis may name the other line.
 */
const asGood = new Set([
  // Moving either of two neighbours gives the same order.
  "first-true-line line 2 moved up",
  "order-of-lines line 2 moved up",
  "farthest-distance line 2 moved up",
]);

/** The diagnosis of the first maze that fails. */
function diagnosed({ challenge, program }: WrongAnswer): { maze: number; diagnosis: Diagnosis } {
  const { verdict, diagnoses } = checkProgram({ task: taskOf(challenge), program });
  const maze = verdict.failure?.maze ?? -1;
  const diagnosis = diagnoses[maze];
  if (diagnosis === null || diagnosis === undefined) throw new Error("no diagnosis");
  return { maze, diagnosis };
}

/**
 * Whether some change of this line alone passes in the maze, or gets past the bump.
 * @param mayBeFurther whether it is enough that the robot reaches more cells
 */
function canHelp(
  challenge: ChallengeDocument,
  program: ProgramDocument,
  maze: number,
  line: LineRef,
  mayBeFurther: boolean,
): boolean {
  const here = challenge.mazes[maze];
  if (here === undefined) return false;
  const alone = { ...challenge, mazes: [here] };
  const before = checkChallenge(alone, program).failure;
  for (const step of [...oneStepFrom(program), ...movesOf(program, line)]) {
    if (step.line !== line && step.line !== null) continue;
    if (step.line === null && step.name !== `without line ${Number(line) + 1}`) continue;
    if (findViolation(challenge, step.program) !== null) continue;
    const { passed, failure } = checkChallenge(alone, step.program);
    const isPast = before?.code === "bump" && (failure?.tick ?? 0) > (before.tick ?? 0);
    const isFurther =
      mayBeFurther &&
      before?.code === "not-reached" &&
      failure?.code === "not-reached" &&
      Number(failure.found) > Number(before.found);
    if (passed || isPast || isFurther) return true;
  }
  return false;
}

/** The line at every other position, and with every number that a student is likely to try. */
function* movesOf(program: ProgramDocument, line: LineRef) {
  const rule = typeof line === "number" ? program.rules[line] : undefined;
  if (rule === undefined || typeof line !== "number") return;
  const others = program.rules.toSpliced(line, 1);
  for (let to = 0; to < program.rules.length; to++) {
    yield { name: "moved", line, program: { ...program, rules: others.toSpliced(to, 0, rule) } };
  }
  const { when } = rule;
  if (when === null) return;
  const numbers = when.than === "right" ? [-100, -50, -10, -1, 0, 1, 10, 50, 100] : allNumbers;
  for (const number of numbers) {
    const changed = when.than === "right" ? { ...when, plus: number } : { ...when, than: number };
    const rules = program.rules.with(line, { ...rule, when: changed });
    yield { name: "number", line, program: { ...program, rules } };
  }
}

const allNumbers = Array.from({ length: 40 }, (_, at) => (at + 1) * 25).concat(60);

describe("wrong answers with one change", () => {
  it("are at least sixty, and come from every mission with a program", () => {
    expect(oneStep.flatMap(({ wrong }) => wrong).length).toBeGreaterThanOrEqual(60);
    for (const { wrong } of oneStep) expect(wrong.length).toBeGreaterThan(0);
  });

  it.each(oneStep)("$id: the line that was changed is named", ({ id, wrong }) => {
    const others = wrong.filter((answer) => {
      const { diagnosis } = diagnosed(answer);
      if (diagnosis.cause === null) return true;
      return causeLine(diagnosis) !== answer.line && !asGood.has(`${id} ${answer.name}`);
    });
    expect(others.map(({ name }) => name)).toEqual([]);
  });
});

describe("a bump", () => {
  const named = (id: string, program: ProgramDocument) => {
    const mission = solved.find((each) => each.id === id);
    if (mission === undefined) throw new Error("no such mission");
    return diagnosed({ name: "", line: 0, challenge: mission.challenge, program }).diagnosis;
  };

  it.each(["reverse", "turn 180", "left 90", "forward"] as const)(
    "is blamed on the line that drove into the wall, whatever a line chooses that never decided (%s)",
    (unread) => {
      const program = lines(
        "forward",
        { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
        { when: { sensor: "left", is: ">", than: 60 }, do: "forward" },
        { when: { sensor: "front", is: "<", than: 50 }, do: unread },
      );
      const { event, cause } = named("faulty-line", program);
      expect(event).toMatchObject({ kind: "bump", line: 1 });
      expect(cause).toMatchObject({ kind: "action", moment: { line: 1, action: "forward" } });
    },
  );

  it("of a robot that drives back at once is blamed on the line that drives back", () => {
    const program = lines("reverse", {
      when: { sensor: "front", is: "<", than: 50 },
      do: "right 90",
    });
    const { cause } = named("right-wall", program);
    expect(cause).toMatchObject({ kind: "action", moment: { line: "default", action: "reverse" } });
  });

  it("is not blamed on a sensor, sign or number whose change solves only one of the mazes", () => {
    const when = { sensor: "front", is: ">", than: 50 } as const;
    const { cause } = named("every-maze", lines("forward", { when, do: "delayed left 90" }));
    expect(cause).toMatchObject({ kind: "action", detail: { kind: "into-wall", side: "left" } });
  });
});

describe("in a mission with several mazes", () => {
  const room = { when: { sensor: "front", is: ">", than: 50 }, do: "forward" } as const;
  const leftIsLonger = { sensor: "left", is: ">", than: "right", plus: 1 } as const;

  it.each([
    ["swapped", "right 90", "left 90"],
    ["left out", "forward", "forward"],
    ["turned round", "turn 180", "turn 180"],
  ] as const)("each maze names the one of two wrong turns that it shows (%s)", (_, left, other) => {
    const found = causes("left-or-right", lines(other, room, { when: leftIsLonger, do: left }));
    expect(found).toMatchObject([
      { kind: "action", moment: { line: 1, action: left, tick: 240 } },
      { kind: "action", moment: { line: "default", action: other, tick: 240 } },
    ]);
  });

  it("a turn to a wall is named, not the right turn of the same line before it", () => {
    const nearWall = { sensor: "front", is: "<", than: 50 } as const;
    const [cause] = causes(
      "farthest-distance",
      lines("forward", { when: nearWall, do: "left 90" }),
    );
    expect(cause).toMatchObject({
      kind: "action",
      moment: { line: 0, tick: 396 },
      detail: { kind: "into-wall", side: "left", open: "right" },
    });
  });
});

describe("an order of the lines that solves every maze", () => {
  it("comes before a delay that gets through one of them", () => {
    const mission = solved.find(({ id }) => id === "farthest-distance");
    if (mission === undefined) throw new Error("no such mission");
    const front = { when: { sensor: "front", is: ">", than: 50 }, do: "forward" } as const;
    const left = {
      when: { sensor: "left", is: ">", than: "right", plus: 1 },
      do: "left 90",
    } as const;
    const program = lines("right 90", left, front);
    const { diagnosis } = diagnosed({ name: "", line: 0, challenge: mission.challenge, program });
    expect(diagnosis.cause).toMatchObject({ kind: "order", line: 1 });
  });
});

describe("wrong answers with two changes", () => {
  it("name the missing delay also where the robot does not bump, and another line is wrong too", () => {
    const mission = solved.find(({ id }) => id === "right-wall");
    if (mission === undefined) throw new Error("no such mission");
    const { challenge, solution } = mission;
    const rules = solution.rules.map((rule, at) => ({
      ...rule,
      do: at === 0 ? ("right 90" as const) : ("turn 180" as const),
    }));
    const { diagnosis } = diagnosed({
      name: "",
      line: 0,
      challenge,
      program: { ...solution, rules },
    });
    expect(diagnosis.event.kind).toBe("late");
    expect(diagnosis.cause).toMatchObject({ kind: "not-delayed", isAtEdge: true });
    expect(causeLine(diagnosis)).toBe(0);
  });

  it.each(solved)("$id: no line is named whose change cannot help", ({ challenge, solution }) => {
    const blamed = [...twoStepAnswers(challenge, solution, 97)].filter((answer) => {
      const { maze, diagnosis } = diagnosed(answer);
      const line = causeLine(diagnosis);
      const { cause } = diagnosis;
      const isMissingDelay = cause?.kind === "not-delayed" && cause.isAtEdge;
      const isIntoWall = cause?.kind === "action" && cause.detail?.kind === "into-wall";
      const mayBeFurther = isMissingDelay || isIntoWall;
      return line !== null && !canHelp(challenge, answer.program, maze, line, mayBeFurther);
    });
    expect(blamed.map(({ name }) => name)).toEqual([]);
  });
});
