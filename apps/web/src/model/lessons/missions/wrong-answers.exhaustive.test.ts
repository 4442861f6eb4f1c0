/**
 * Sweeps over the wrong answers to each mission with a program. Each answer is checked once, which
 * takes up to a second, and everything that a student reads about it is compared with this check.
 */
import {
  checkChallenge,
  findViolation,
  lessonOf,
  rightsOf,
  taskOf,
  type ChallengeDocument,
} from "@corridor/challenge";
import { adviseProgram, causeLine, type Advice, type Cause, type Diagnosis } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { concernsReader } from "../../advice/advice-in-challenge.ts";
import type { CheckAnswer } from "../../check/checked-task.ts";
import { falseSentences } from "../../diagnosis/testing/sentence-claims.ts";
import { failureText } from "../failure-text.ts";
import { checkProgram } from "../testing/check-program.ts";
import { plain, words } from "../testing/mission-words.ts";
import { solved } from "./testing/causes.ts";
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
 * One test for each answer: on a busy machine, all answers of a mission exceed the timeout of a
 * test.
 */
const oneStepCases = oneStep.flatMap(({ id, wrong }) =>
  wrong.map((answer) => ({ id, name: answer.name, answer })),
);
const twoStepCases = solved.flatMap(({ id, challenge, solution }) =>
  [...twoStepAnswers(challenge, solution, 97)].map((answer) => ({ id, name: answer.name, answer })),
);

const check = ({ challenge, program }: WrongAnswer): CheckAnswer =>
  checkProgram({ task: taskOf(challenge), program });

/** The diagnosis of the first maze that fails. */
function firstDiagnosis({ verdict, diagnoses }: CheckAnswer): {
  maze: number;
  diagnosis: Diagnosis;
} {
  const maze = verdict.failure?.maze ?? -1;
  const diagnosis = diagnoses[maze];
  if (diagnosis === null || diagnosis === undefined) throw new Error("no diagnosis");
  return { maze, diagnosis };
}

/**
 * Pairs of changes that fix a mistake equally well, so that the diagnosis may name the other line.
 */
const asGood = new Set([
  // Moving either of two neighbours gives the same order.
  "first-true-line line 2 moved up",
  "order-of-lines line 2 moved up",
  "farthest-distance line 2 moved up",
]);

function namesChangedLine(id: string, answer: WrongAnswer, checked: CheckAnswer): boolean {
  const { diagnosis } = firstDiagnosis(checked);
  if (diagnosis.cause === null) return false;
  return causeLine(diagnosis) === answer.line || asGood.has(`${id} ${answer.name}`);
}

/** The lines that the mazes blame, each once. */
function blamedLines({ diagnoses }: CheckAnswer): Set<LineRef | null> {
  const causes = diagnoses.flatMap((diagnosis) => diagnosis?.cause ?? []);
  return new Set(causes.map((cause) => causeLine({ cause })));
}

/**
 * Causes that agree with the advice on the same line. Advice with `why: "free"` means that the turn
 * uses the wrong sensor.
 */
const sameSaid: Partial<Record<Advice["kind"], readonly Cause["kind"][]>> = {
  "immediate-into-opening": ["not-delayed"],
  "delayed-about-front": ["delayed", "action", "missing", "sensor"],
};

function contradicts(advice: Advice, diagnosis: Diagnosis): boolean {
  const { cause } = diagnosis;
  if (cause === null) return false;
  const said = sameSaid[advice.kind];
  // A line that never decides cannot be the line that decided.
  if (said === undefined) return cause.moment.line === advice.line;
  return causeLine(diagnosis) === advice.line && !said.includes(cause.kind);
}

/** The advice before the run that contradicts the verdict after it. */
function contradictingAdvice(
  { challenge, program }: WrongAnswer,
  { diagnoses }: CheckAnswer,
): Advice[] {
  const place = { lesson: lessonOf(challenge), index: 0, rights: rightsOf(challenge) };
  return challenge.mazes.flatMap((maze, at) => {
    const diagnosis = diagnoses[at] ?? null;
    if (diagnosis === null) return [];
    return adviseProgram(program, maze)
      .filter((advice) => concernsReader(advice, program, place))
      .filter((advice) => contradicts(advice, diagnosis));
  });
}

/** The false sentences of the mission's card, for each maze that fails. */
function falseIn(
  { challenge, program }: WrongAnswer,
  { verdict, diagnoses }: CheckAnswer,
): string[] {
  return verdict.mazes.flatMap(({ failure }, at) => {
    const maze = challenge.mazes[at];
    if (failure === null || maze === undefined) return [];
    const text = plain(failureText(words, challenge, failure, diagnoses[at] ?? null));
    const own = text.replace(/^Maze \d: /u, "");
    const end = failure.tick ?? challenge.checks.seconds * 60;
    return falseSentences(maze, program, own, end).map(
      (each) => `maze ${at + 1}: ${each} | ${own}`,
    );
  });
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

/** The line that the diagnosis blames although no change of it can help; null if there is none. */
function blamedInVain({ challenge, program }: WrongAnswer, checked: CheckAnswer): LineRef | null {
  const { maze, diagnosis } = firstDiagnosis(checked);
  const line = causeLine(diagnosis);
  const { cause } = diagnosis;
  const isMissingDelay = cause?.kind === "not-delayed" && cause.isAtEdge;
  const isIntoWall = cause?.kind === "action" && cause.detail?.kind === "into-wall";
  const mayBeFurther = isMissingDelay || isIntoWall;
  if (line === null || canHelp(challenge, program, maze, line, mayBeFurther)) return null;
  return line;
}

describe("a wrong answer with one change", () => {
  it("exists at least sixty times, and in every mission with a program", () => {
    expect(oneStepCases.length).toBeGreaterThanOrEqual(60);
    for (const { wrong } of oneStep) expect(wrong.length).toBeGreaterThan(0);
  });

  it.each(oneStepCases)(
    "names the changed line, in every maze, and agrees with the advice and the run: $id, $name",
    ({ id, answer }) => {
      const checked = check(answer);
      expect(namesChangedLine(id, answer, checked)).toBe(true);
      expect(blamedLines(checked).size).toBe(1);
      expect(contradictingAdvice(answer, checked)).toEqual([]);
      expect(falseIn(answer, checked)).toEqual([]);
    },
  );
});

describe("a wrong answer with two changes", () => {
  it.each(twoStepCases)(
    "names a line whose change can help, and agrees with the advice and the run: $id, $name",
    ({ answer }) => {
      const checked = check(answer);
      expect(blamedInVain(answer, checked)).toBeNull();
      expect(contradictingAdvice(answer, checked)).toEqual([]);
      expect(falseIn(answer, checked)).toEqual([]);
    },
  );
});
