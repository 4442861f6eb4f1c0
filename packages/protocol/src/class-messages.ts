/**
 * Messages on the WebSocket of a class, by direction. Each message is one JSON text. The first
 * message of each client is `hello`, and the relay responds with `welcome`.
 */
import { z } from "zod";
import {
  classSettingsSchema,
  lessonVersionSchema,
  MAX_PROGRAM_LINK,
  MAX_RENAMES,
  studentNameSchema,
  studentViewSchema,
} from "./class.ts";
import {
  MAX_PROGRESS,
  progressRecordSchema,
  progressSchema,
  progressSeqSchema,
} from "./class-progress.ts";
import {
  countSchema,
  hintNumberSchema,
  studentNumberSchema,
  taskNumberSchema,
} from "./class-quantities.ts";
import { tileSchema } from "./class-tile.ts";
import { eventStreamSchema, sinceSchema } from "./events.ts";
import { problemSchema } from "./problem.ts";
import { keySchema } from "./registration.ts";
import { PROTOCOL_VERSION } from "./version.ts";

const version = z.literal(PROTOCOL_VERSION, { error: `protocol version ${PROTOCOL_VERSION}` });
const linkError = `the text of a link, at most ${MAX_PROGRAM_LINK} characters`;
const contentError = "an object";
const content = z.looseObject({}, { error: contentError });

const heartbeat = z.strictObject({ type: z.literal("heartbeat") });
/** acknowledges the message with this `seq`; the relay sends at most 2 unacknowledged ones */
const seen = z.strictObject({ type: z.literal("seen"), seq: countSchema });
const refused = z.strictObject({ type: z.literal("problem"), problem: problemSchema });

export const classRoles = ["teach", "show", "learn"] as const;
export type ClassRole = (typeof classRoles)[number];

/** The first message of every connection, at most 1 KiB: the client's role and key. */
export const classHelloSchema = z.strictObject({
  type: z.literal("hello"),
  version,
  /** teach: a dashboard; show: a big screen; learn: a student */
  role: z.enum(classRoles, { error: `one of ${classRoles.join(", ")}` }),
  key: keySchema,
  /** from a dashboard that reconnects: the last event that it received */
  since: sinceSchema.optional(),
});
export type ClassHello = z.infer<typeof classHelloSchema>;

export const studentToRelaySchema = z.discriminatedUnion(
  "type",
  [
    z.strictObject({ type: z.literal("tile"), tile: tileSchema }),
    /** stored under its number; repeated until `stored` confirms it */
    z.strictObject({ type: z.literal("progress"), seq: progressSeqSchema, event: progressSchema }),
    /** replaces the stored program; repeated until `stored` confirms it */
    z.strictObject({
      type: z.literal("program"),
      /** chosen by the page, for `stored` */
      seq: countSchema,
      task: taskNumberSchema,
      link: z
        .string({ error: linkError })
        .min(1, { error: linkError })
        .max(MAX_PROGRAM_LINK, { error: linkError }),
    }),
    z.strictObject({
      type: z.literal("help"),
      wanted: z.boolean({ error: "true or false" }),
    }),
    /** asks for another name */
    z.strictObject({ type: z.literal("name") }),
  ],
  { error: "one of tile, progress, program, help, name" },
);
export type StudentToRelay = z.infer<typeof studentToRelaySchema>;

const renamesLeft = z.int().min(0).max(MAX_RENAMES);
const pauseEndsInMs = classSettingsSchema.shape.pauseEndsInMs;
const paceTo = classSettingsSchema.shape.paceTo;

export const relayToStudentSchema = z.discriminatedUnion("type", [
  z.strictObject({
    type: z.literal("welcome"),
    version,
    student: studentNumberSchema,
    name: studentNameSchema,
    renamesLeft,
    /** number of the newest stored progress record; 0 if there is none */
    progress: z.int().min(0).max(MAX_PROGRESS),
    helpWanted: z.boolean(),
    /** whether a teacher watches this student */
    watched: z.boolean(),
    pauseEndsInMs,
    paceTo,
    lesson: lessonVersionSchema,
  }),
  /** the teacher has sent a lesson, which `GET .../lesson` returns with this as its `ETag` */
  z.strictObject({ type: z.literal("lesson"), version: lessonVersionSchema }),
  /** a pause starts, or ends (null) */
  z.strictObject({ type: z.literal("pause"), endsInMs: pauseEndsInMs }),
  z.strictObject({ type: z.literal("pace"), to: paceTo }),
  z.strictObject({ type: z.literal("watched"), watched: z.boolean() }),
  /** the teacher shows a hint */
  z.strictObject({ type: z.literal("hint"), task: taskNumberSchema, hint: hintNumberSchema }),
  z.strictObject({ type: z.literal("name"), name: studentNameSchema, renamesLeft }),
  /** the record or program with this number is stored */
  z.strictObject({
    type: z.literal("stored"),
    what: z.enum(["progress", "program"]),
    seq: countSchema,
  }),
  refused,
  heartbeat,
]);
export type RelayToStudent = z.infer<typeof relayToStudentSchema>;

export const teacherToRelaySchema = z.discriminatedUnion(
  "type",
  [
    /** receives the tiles of one student more often; null: of nobody */
    z.strictObject({ type: z.literal("watch"), student: studentNumberSchema.nullable() }),
    z.strictObject({
      type: z.literal("hint"),
      student: studentNumberSchema,
      task: taskNumberSchema,
      hint: hintNumberSchema,
    }),
    /** replaces what the big screens show; the relay forwards it and does not store it */
    z.strictObject({
      type: z.literal("display"),
      content,
      /**
       * does not replace content with a higher priority, until the dashboard that sent it closes;
       * without it: replaces any content, and any content replaces it
       */
      priority: z.int({ error: "a whole number" }).optional(),
    }),
    seen,
  ],
  { error: "one of watch, hint, display, seen" },
);
export type TeacherToRelay = z.infer<typeof teacherToRelaySchema>;

/** The connection and the newest tile of a student. */
const studentTile = z.strictObject({
  student: studentNumberSchema,
  connected: z.boolean(),
  /** null: none since the relay started, or the student has not sent one */
  tile: tileSchema.nullable(),
});
export type StudentTile = z.infer<typeof studentTile>;

export const relayToTeacherSchema = z.discriminatedUnion("type", [
  z.strictObject({
    type: z.literal("welcome"),
    version,
    /** with the `n` of an event, as STREAM-n: the `since` of the next connection */
    stream: eventStreamSchema,
    /** events after this one follow; null if events were missed: a `gap` follows */
    n: countSchema.nullable(),
    settings: classSettingsSchema,
  }),
  /**
   * students whose tile or connection changed since the last batch, at most two batches a second,
   * or five while the dashboard watches a student
   */
  z.strictObject({ type: z.literal("tiles"), seq: countSchema, tiles: z.array(studentTile) }),
  /** a student joined or changed; `progress` is a new record */
  z.strictObject({
    type: z.literal("student"),
    n: countSchema,
    student: studentViewSchema,
    progress: progressRecordSchema.nullable(),
  }),
  z.strictObject({ type: z.literal("removed"), n: countSchema, student: studentNumberSchema }),
  z.strictObject({ type: z.literal("settings"), n: countSchema, settings: classSettingsSchema }),
  /** replaces missed events: read the class with `GET /classes/ID` */
  z.strictObject({ type: z.literal("gap"), n: countSchema }),
  /**
   * the priority of what the big screens show now, if a dashboard has replaced it; null: its
   * dashboard has closed, and any content replaces it
   */
  z.strictObject({ type: z.literal("displayed"), priority: z.int().nullable() }),
  refused,
  heartbeat,
]);
export type RelayToTeacher = z.infer<typeof relayToTeacherSchema>;

/** A numbered event of a class. */
export type ClassEvent = Extract<RelayToTeacher, { type: "student" | "removed" | "settings" }>;

export const screenToRelaySchema = z.discriminatedUnion("type", [seen], { error: "seen" });
export type ScreenToRelay = z.infer<typeof screenToRelaySchema>;

export const relayToScreenSchema = z.discriminatedUnion("type", [
  z.strictObject({
    type: z.literal("welcome"),
    version,
    code: classSettingsSchema.shape.code,
    lesson: lessonVersionSchema,
  }),
  z.strictObject({ type: z.literal("code"), code: classSettingsSchema.shape.code }),
  z.strictObject({ type: z.literal("lesson"), version: lessonVersionSchema }),
  /** the newest content from a dashboard; newer content replaces unsent content */
  z.strictObject({ type: z.literal("display"), seq: countSchema, content }),
  refused,
  heartbeat,
]);
export type RelayToScreen = z.infer<typeof relayToScreenSchema>;
