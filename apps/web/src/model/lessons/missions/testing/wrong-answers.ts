/**
 * Wrong answers to the missions that need a program. They are all changes of one or two parts of a
 * solution that the mission allows and that fail. Enumeration avoids a biased selection.
 */
import { findViolation, checkChallenge, type ChallengeDocument } from "@corridor/challenge";
import type { Condition, ProgramDocument, Rule } from "@corridor/program";
import { menuActions } from "@corridor/program";

/** One change of a solution. */
interface Step {
  /** position of the change, for the title of a test */
  name: string;
  program: ProgramDocument;
  /** the changed line; null if a line was removed */
  line: number | "default" | null;
}

export interface WrongAnswer extends Step {
  challenge: ChallengeDocument;
}

const numbers = [4, 20, 50, 100, 150, 250, 400];

/** Every program that differs from this one in one part. */
export function* oneStepFrom(program: ProgramDocument): Generator<Step> {
  const { rules } = program;
  const put = (at: number, rule: Rule): ProgramDocument => ({
    ...program,
    rules: rules.with(at, rule),
  });
  for (const [at, rule] of rules.entries()) {
    for (const action of menuActions) {
      if (action === rule.do) continue;
      yield {
        name: `line ${at + 1}: ${action}`,
        line: at,
        program: put(at, { ...rule, do: action }),
      };
    }
    for (const when of otherConditions(rule.when)) {
      const text = JSON.stringify(when);
      yield { name: `line ${at + 1}: ${text}`, line: at, program: put(at, { ...rule, when }) };
    }
    if (at > 0) {
      const moved = rules.toSpliced(at, 1).toSpliced(at - 1, 0, rule);
      yield {
        name: `line ${at + 1} moved up`,
        line: at - 1,
        program: { ...program, rules: moved },
      };
    }
    const without = { ...program, rules: rules.toSpliced(at, 1) };
    yield { name: `without line ${at + 1}`, line: null, program: without };
  }
  for (const action of menuActions) {
    if (action === program.default) continue;
    yield {
      name: `otherwise: ${action}`,
      line: "default",
      program: { ...program, default: action },
    };
  }
}

function* otherConditions(when: Condition | null): Generator<Condition> {
  if (when === null) return;
  yield { ...when, is: when.is === ">" ? "<" : ">" };
  if (when.than === "right") return;
  for (const than of numbers) if (than !== when.than) yield { ...when, than };
  for (const sensor of ["front", "back", "left", "right"] as const) {
    if (sensor !== when.sensor) yield { ...when, sensor };
  }
}

/** All allowed answers with one change that fail. */
export function* oneStepAnswers(
  challenge: ChallengeDocument,
  solution: ProgramDocument,
): Generator<WrongAnswer> {
  for (const step of oneStepFrom(solution)) {
    if (isWrong(challenge, step.program)) yield { ...step, challenge };
  }
}

/** Of the allowed answers with two changes, every `every`-th one if it fails. */
export function* twoStepAnswers(
  challenge: ChallengeDocument,
  solution: ProgramDocument,
  every: number,
): Generator<WrongAnswer> {
  let at = 0;
  for (const first of oneStepFrom(solution)) {
    for (const second of oneStepFrom(first.program)) {
      if (findViolation(challenge, second.program) !== null || at++ % every !== 0) continue;
      if (!isWrong(challenge, second.program)) continue;
      yield { ...second, name: `${first.name}, ${second.name}`, challenge };
    }
  }
}

function isWrong(challenge: ChallengeDocument, program: ProgramDocument): boolean {
  if (findViolation(challenge, program) !== null) return false;
  return !checkChallenge(challenge, program).passed;
}
