/**
 * The lesson, `corridor/challenge` version 2: one or more tasks and a survey. A challenge document of
 * version 1 is a lesson of one task.
 */
import { readJson, readValue, type ReadResult } from "@corridor/protocol";
import { z } from "zod";
import { challengeSchema, parseChallenge, type ChallengeDocument } from "./challenge-document.ts";
import {
  MAX_CHALLENGE_TEXT_LENGTH,
  MAX_LANGUAGE_LENGTH,
  MAX_LESSON_SECONDS,
  MAX_QUESTION_LENGTH,
  MAX_SURVEY_QUESTIONS,
  MAX_TASK_LENGTH,
  MAX_TASKS,
} from "./challenge-limits.ts";
import { allowedInLesson, findContradictions, taskFields, textOf } from "./task-schema.ts";
import { unseenSchema } from "./unseen-mazes.ts";
import { MAX_NAME_LENGTH } from "@corridor/program";

/** A task, whose fields may contradict each other. */
const draftTask = z.strictObject(
  {
    ...taskFields(MAX_LESSON_SECONDS),
    allowed: allowedInLesson,
    /** generated mazes in which an attempt must pass as well, or null */
    unseen: unseenSchema.nullable(),
  },
  { error: "a task: an object" },
);
export type LessonTask = z.infer<typeof draftTask>;

const task = draftTask.check(({ value, issues }) => {
  findContradictions(value, (path, message) => {
    issues.push({ code: "custom", path, message, input: value });
  });
});

const LANGUAGE = /^[A-Za-z]{2,8}(?:-[A-Za-z0-9]{1,8})*$/;
const language = z
  .string({ error: 'a language tag such as "en" or "pt-BR", or null' })
  .max(MAX_LANGUAGE_LENGTH, { error: `at most ${MAX_LANGUAGE_LENGTH} characters` })
  .regex(LANGUAGE, { error: 'a language tag such as "en" or "pt-BR", or null' });

const question = z.strictObject(
  {
    /** column of the answers in a table */
    id: z.string({ error: "a text" }).regex(/^[a-z][a-z0-9_]{0,31}$/, {
      error: "1 to 32 small letters, digits and _, beginning with a letter",
    }),
    question: textOf(MAX_QUESTION_LENGTH),
  },
  { error: 'a question: {"id": ..., "question": ...}' },
);

const VERSIONS = "version 1 or 2, the newest that this Corridor reads";

/** A list of 1 to 12 tasks. */
const tasksOf = (each: typeof draftTask) =>
  z
    .array(each, { error: "a list of tasks" })
    .min(1, { error: "at least one task" })
    .max(MAX_TASKS, { error: `at most ${MAX_TASKS} tasks` });

export const lessonSchema = z.strictObject(
  {
    format: z.literal("corridor/challenge", { error: '"corridor/challenge"' }),
    version: z.literal(2, { error: VERSIONS }),
    /** BCP 47 tag of the texts; null: the language of the page */
    language: language.nullable(),
    name: textOf(MAX_NAME_LENGTH),
    intro: textOf(MAX_TASK_LENGTH),
    /** `in turn`: a task opens when the one before it is solved */
    order: z.enum(["any", "in turn"], { error: '"any" or "in turn"' }),
    tasks: tasksOf(task),
    /** questions with answers from 1 (no help) to 5 (very helpful) */
    survey: z
      .array(question, { error: "a list of questions" })
      .max(MAX_SURVEY_QUESTIONS, { error: `at most ${MAX_SURVEY_QUESTIONS} questions` })
      .refine((list) => new Set(list.map(({ id }) => id)).size === list.length, {
        error: "no duplicate ids",
      }),
  },
  { error: "a lesson: an object" },
);
export type LessonDocument = z.infer<typeof lessonSchema>;

const draftSchema = lessonSchema.extend({ tasks: tasksOf(draftTask) });

/** A challenge document of either version. */
export const challengeOrLessonSchema = z.discriminatedUnion(
  "version",
  [challengeSchema, lessonSchema],
  {
    error: ({ input }) =>
      typeof input === "object" && input !== null && !Array.isArray(input)
        ? VERSIONS
        : "a lesson: an object",
  },
);

/** Reads a lesson of either version from a parsed value. */
export function parseLesson(input: unknown): ReadResult<LessonDocument> {
  return asLesson(readValue(challengeOrLessonSchema, input));
}

/** Reads a lesson of either version from JSON text. */
export function readLesson(text: string): ReadResult<LessonDocument> {
  return asLesson(readJson(challengeOrLessonSchema, text, MAX_CHALLENGE_TEXT_LENGTH));
}

/**
 * Reads a lesson that is still being written: version 2, whose fields may contradict each other. A
 * maze may lack the goal that its task requires, for example.
 */
export function readLessonDraft(text: string): ReadResult<LessonDocument> {
  return readJson(draftSchema, text, MAX_CHALLENGE_TEXT_LENGTH);
}

/** The lesson of one task that a challenge document contains. */
export function lessonOf(challenge: ChallengeDocument): LessonDocument {
  return {
    format: challenge.format,
    version: 2,
    language: null,
    name: "",
    intro: "",
    order: "any",
    tasks: [taskOf(challenge)],
    survey: [],
  };
}

/** The task that a challenge document is. */
export function taskOf(challenge: ChallengeDocument): LessonTask {
  const { format: _format, version: _version, allowed, ...rest } = challenge;
  return { ...rest, allowed: { ...allowed, tools: null, help: null }, unseen: null };
}

/** The document to write: version 1 if it can hold the lesson, so that older pages read it. */
export function oldestDocumentOf(lesson: LessonDocument): ChallengeDocument | LessonDocument {
  const [first, ...others] = lesson.tasks;
  const isPlain =
    lesson.language === null &&
    lesson.name === "" &&
    lesson.intro === "" &&
    lesson.order === "any" &&
    lesson.survey.length === 0;
  if (first === undefined || others.length > 0 || !isPlain) return lesson;
  const { unseen, allowed, ...rest } = first;
  const { tools, help, ...plainAllowed } = allowed;
  if (unseen !== null || tools !== null || help !== null) return lesson;
  const read = parseChallenge({
    format: lesson.format,
    version: 1,
    ...rest,
    allowed: plainAllowed,
  });
  // Longer times exceed the bounds of version 1.
  return read.ok ? read.value : lesson;
}

function asLesson(
  read: ReadResult<ChallengeDocument | LessonDocument>,
): ReadResult<LessonDocument> {
  if (!read.ok) return read;
  const { value } = read;
  return { ok: true, value: value.version === 1 ? lessonOf(value) : value };
}
