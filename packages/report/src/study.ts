/** What a class did: times and counts by student and task, and the answers to the survey. */
import { z } from "zod";

/** The longest life of a class is 12 hours. */
const MAX_SECONDS = 12 * 60 * 60;
const MAX_COUNT = 1_000_000;
const MAX_LINES = 200;
/** Longest label of a student or task. */
export const MAX_LABEL = 100;

const label = z
  .string()
  .trim()
  .min(1)
  .max(MAX_LABEL, { error: `at most ${MAX_LABEL} characters` });
/** null: anonymous */
const student = label.nullable();

function wholeNumber(max: number, unit: string) {
  const error = `a whole number of ${unit}, 0 to ${max}, or nothing`;
  return z.int({ error }).min(0, { error }).max(max, { error }).nullable();
}

const seconds = `seconds, 0 to ${MAX_SECONDS}, or nothing`;

/** The work of one student on one task. Null: not known. */
export const workSchema = z.strictObject({
  student,
  task: label,
  /** from opening the task to the first verified solution, without pauses; null: not solved */
  seconds: z
    .number({ error: seconds })
    .min(0, { error: seconds })
    .max(MAX_SECONDS, { error: seconds })
    .nullable(),
  /** of the solution, without "otherwise" */
  lines: wholeNumber(MAX_LINES, "lines"),
  /** first runs or checks of a changed program */
  attempts: wholeNumber(MAX_COUNT, "attempts"),
  runs: wholeNumber(MAX_COUNT, "runs"),
  bumps: wholeNumber(MAX_COUNT, "bumps"),
  failedChecks: wholeNumber(MAX_COUNT, "failed checks"),
  hints: wholeNumber(MAX_COUNT, "hints"),
  /** mistakes that the diagnosis found */
  mistakes: wholeNumber(MAX_COUNT, "mistakes"),
});
export type Work = z.infer<typeof workSchema>;

const rating = "an answer from 1 (no help) to 5 (very helpful), or nothing";
export const answerSchema = z.literal([1, 2, 3, 4, 5], { error: rating }).nullable();

/**
 * A student's answers by the ids of the questions. Null: skipped. A student who only joined has
 * answers, too: none.
 */
export interface Answers {
  student: string | null;
  answers: Readonly<Record<string, 1 | 2 | 3 | 4 | 5 | null>>;
}
export const answersSchema = z.strictObject({
  student,
  answers: z.record(z.string(), answerSchema),
});

/** The answer to a question, which other tables of the study may have. */
export function answerTo({ answers }: Pick<Answers, "answers">, id: string) {
  // An id can be the name of a property of all objects, such as "constructor".
  return Object.hasOwn(answers, id) ? (answers[id] ?? null) : null;
}

export interface Study {
  work: readonly Work[];
  survey: readonly Answers[];
}
