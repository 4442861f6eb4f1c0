/**
 * A class: a teacher's live lesson, which students join with a code. There are no accounts. The
 * service deletes a class when the teacher ends it, after 2 hours without use, and 12 hours after
 * its creation.
 */
import { z } from "zod";
import { progressRecordSchema } from "./class-progress.ts";
import { studentNumberSchema, taskNumberSchema, wholeNumber } from "./class-quantities.ts";
import { sinceSchema } from "./events.ts";
import { PAIRING_LETTERS } from "./pairing.ts";
import { keySchema } from "./registration.ts";

export const MAX_STUDENTS = 200;
/** Number of words in each language's list of names. */
export const NAME_WORDS = 256;
export const MAX_STUDENT_NAME = 24;
export const CLASS_CODE_LENGTH = 6;
/** How often a student may change the name. */
export const MAX_RENAMES = 2;
/** Bounds of a pause, in seconds. */
export const PAUSE_SECONDS = { min: 10, max: 1_800 } as const;

/** Longest typed code, which may contain spaces and hyphens. */
const MAX_TYPED = 32;

const idError = "the 22 characters of a class's id";
export const classIdSchema = z
  .string({ error: idError })
  .regex(/^[A-Za-z0-9_-]{22}$/, { error: idError });

const codeError = `the ${CLASS_CODE_LENGTH} letters of a class's code, such as BCD FGH`;
const letters = `[${PAIRING_LETTERS}${PAIRING_LETTERS.toLowerCase()}]`;
/** Accepts a code as typed, and returns only its letters, in upper case. */
const typedCodeSchema = z
  .string({ error: codeError })
  .max(MAX_TYPED, { error: codeError })
  .regex(new RegExp(`^[ -]*(?:${letters}[ -]*){${CLASS_CODE_LENGTH}}$`), { error: codeError })
  .transform((typed) => typed.toUpperCase().replaceAll(/[ -]/g, ""));

/** A code as the service creates it. */
const createdCode = z.string().length(CLASS_CODE_LENGTH);

const studentNameError = `a name of 1 to ${MAX_STUDENT_NAME} characters, without line breaks`;
const studentName = z
  .string({ error: studentNameError })
  .min(1, { error: studentNameError })
  .max(MAX_STUDENT_NAME, { error: studentNameError })
  .refine((name) => name === name.trim() && !/[\p{Cc}\p{Zl}\p{Zp}]/u.test(name), {
    error: studentNameError,
  });
const namesError = `null, or a list of 1 to ${NAME_WORDS} different names`;
const expectedError = `null, or a number of students from 1 to ${MAX_STUDENTS}`;

/** The fields of a request for a class besides its lesson, whose schema is in another package. */
export const classFields = {
  /** pseudonyms for the students; null: words of a list in the language of each page */
  names: z
    .array(studentName, { error: namesError })
    .min(1, { error: namesError })
    .max(NAME_WORDS, { error: namesError })
    .refine((names) => new Set(names).size === names.length, { error: namesError })
    .nullable()
    .default(null),
  /** number of students; the class locks when as many have joined; null: unknown */
  expected: wholeNumber(expectedError, 1, MAX_STUDENTS).nullable().default(null),
};

const seconds = z.int().min(0);
const endsInSeconds = seconds.describe("until the relay deletes the class at the latest");

/** The only response that contains the keys: the service stores their hashes. */
export const createdClassSchema = z.strictObject({
  id: classIdSchema,
  code: createdCode.describe("for the students to type"),
  teacherKey: keySchema.describe("authorises everything in this class"),
  screenKey: keySchema.describe("authorises a big screen, which reads the lesson"),
  address: z.url({ error: "a web address" }).max(300).describe("the teacher's dashboard"),
  endsInSeconds,
});
export type CreatedClass = z.infer<typeof createdClassSchema>;

/** A request to join the class that has the code, or to return to it on another device. */
export const joinRequestSchema = z.strictObject({ code: typedCodeSchema });

/**
 * The name of a student: the number of a word in the list of each language, or a pseudonym from the
 * teacher. Exactly one of both is not null.
 */
export const studentNameSchema = z.strictObject({
  word: z
    .int()
    .min(0)
    .max(NAME_WORDS - 1)
    .nullable(),
  text: z.string().max(MAX_STUDENT_NAME).nullable(),
});
export type StudentName = z.infer<typeof studentNameSchema>;

/** The only response that contains the key of the student. */
export const joinedClassSchema = z.strictObject({
  class: classIdSchema,
  student: studentNumberSchema,
  name: studentNameSchema,
  key: keySchema.describe("authorises this student; an earlier key of the student is invalid"),
});
export type JoinedClass = z.infer<typeof joinedClassSchema>;

const renamesLeft = z.int().min(0).max(MAX_RENAMES);

/** A student as the teacher sees it. */
export const studentViewSchema = z.strictObject({
  student: studentNumberSchema,
  name: studentNameSchema,
  renamesLeft: renamesLeft.describe("how often the student may still change the name"),
  joinedAt: z.iso.datetime(),
  helpSince: z.iso.datetime().nullable().describe("when the student asked for help; null: not"),
  programs: z.int().min(0).describe("number of stored programs; the newest one can be read"),
});
export type StudentView = z.infer<typeof studentViewSchema>;

const versionError = "the 22 characters of a lesson's version";
/** The version of a lesson, which is its `ETag` without quotation marks. */
export const lessonVersionSchema = z
  .string({ error: versionError })
  .regex(/^[A-Za-z0-9_-]{22}$/, { error: versionError });

const pauseError = `seconds from ${PAUSE_SECONDS.min} to ${PAUSE_SECONDS.max}`;
/** A request to pause all students. */
export const pauseRequestSchema = z.strictObject({
  seconds: wholeNumber(pauseError, PAUSE_SECONDS.min, PAUSE_SECONDS.max),
});

/** The tasks that are open: those up to this number. */
export const paceSchema = z.strictObject({ to: taskNumberSchema });

/** What the teacher has set. */
export const classSettingsSchema = z.strictObject({
  code: createdCode,
  locked: z.boolean().describe("whether the code admits nobody"),
  pauseEndsInMs: z.int().min(0).nullable().describe("null: the class is not paused"),
  paceTo: taskNumberSchema.nullable().describe("null: all tasks are open"),
  lesson: lessonVersionSchema,
});
export type ClassSettings = z.infer<typeof classSettingsSchema>;

/** A student with the stored progress. */
export const classStudentSchema = studentViewSchema.extend({
  progress: z.array(progressRecordSchema).describe("in order"),
});

/** The class as its teacher reads it. */
export const classViewSchema = z.strictObject({
  id: classIdSchema,
  now: z.iso.datetime().describe("by the relay's clock"),
  activeMs: z.int().min(0).describe("ms since the class was created, without its pauses"),
  endsInSeconds,
  expected: z.int().min(1).max(MAX_STUDENTS).nullable(),
  settings: classSettingsSchema,
  students: z.array(classStudentSchema),
  since: sinceSchema.describe("number of the newest event in this response"),
});
export type ClassView = z.infer<typeof classViewSchema>;

/** The response to a request for a new code. */
export const classCodeSchema = z.strictObject({ code: createdCode });
export type ClassCode = z.infer<typeof classCodeSchema>;

/** A code by which another device becomes a student. */
export const returnCodeSchema = z.strictObject({ code: createdCode, endsInSeconds: seconds });
export type ReturnCode = z.infer<typeof returnCodeSchema>;

/** Longest link text of a program. */
export const MAX_PROGRAM_LINK = 4_096;

/** The newest program of a student. */
export const studentProgramSchema = z.strictObject({
  task: taskNumberSchema,
  link: z
    .string()
    .min(1)
    .max(MAX_PROGRAM_LINK)
    .describe("the text of a link, without the address of the page"),
  storedAt: z.iso.datetime(),
});
export type StudentProgram = z.infer<typeof studentProgramSchema>;
