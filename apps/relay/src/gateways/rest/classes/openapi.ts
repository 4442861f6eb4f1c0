/** Operations on classes. */
import { challengeOrLessonSchema } from "@corridor/challenge/document";
import {
  classCodeSchema,
  classViewSchema,
  createdClassSchema,
  joinedClassSchema,
  joinRequestSchema,
  paceSchema,
  pauseRequestSchema,
  returnCodeSchema,
  studentProgramSchema,
} from "@corridor/protocol";
import type { z } from "zod";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { ifNoneMatchHeader } from "../../../platform/http/entity-tags.ts";
import {
  answer,
  entityTag,
  location,
  parameters,
  refusals,
} from "../../../platform/openapi/parts.ts";
import { classPath, classRequestSchema, studentPath } from "./reading.ts";

/** Errors of every operation with a key of a class. */
const keyed = ["bad-request", "not-authorised", "forbidden", "no-class"] as const;
const teacher = [{ teacherKey: [] }];
const anyMember = [...teacher, { screenKey: [] }, { studentKey: [] }];
const ofClass = parameters("path", classPath);
const ofStudent = parameters("path", studentPath);

function body(schema: z.ZodType) {
  return { required: true, content: { "application/json": { schema } } };
}

const stored = { 204: { description: "The setting is stored." } };

export const classCalls: ZodOpenApiPathsObject = {
  "/api/v1/classes": {
    post: {
      operationId: "createClass",
      summary: "Create a class with a lesson",
      description:
        "The response contains the keys, which are returned only once. The relay deletes the class when the teacher ends " +
        "it, after 2 hours without use, and 12 hours after its creation. An address can create 20 classes at once, " +
        "then one every 10 s. The request has at most 64 KiB.",
      security: [],
      requestBody: body(classRequestSchema),
      responses: {
        201: answer("The class, with its code and keys.", createdClassSchema, location),
        ...refusals("bad-request", "too-large", "not-json", "too-fast", "storage-full"),
      },
    },
  },
  "/api/v1/joins": {
    post: {
      operationId: "joinClass",
      summary: "Join a class with its code, or return to it with a return code",
      description:
        "Students type no name: the class assigns one. `word` is the number of a word, which each page shows in its " +
        "language, and `text` is a pseudonym that the teacher entered. The relay checks the codes of one network in " +
        "order of arrival, at most 5 a second after wrong codes.",
      security: [],
      requestBody: body(joinRequestSchema),
      responses: {
        201: answer("The student, with a key that is returned only once.", joinedClassSchema),
        ...refusals("bad-request", "no-class", "class-locked", "class-full", "too-large"),
        ...refusals("not-json", "too-fast", "storage-full"),
      },
    },
  },
  "/api/v1/classes/{id}": {
    parameters: ofClass,
    get: {
      operationId: "readClass",
      summary: "Read the class and its students",
      security: teacher,
      responses: { 200: answer("The class.", classViewSchema), ...refusals(...keyed) },
    },
    delete: {
      operationId: "endClass",
      summary: "End the class",
      description: "The relay deletes the class with all of its data.",
      security: teacher,
      responses: {
        204: { description: "The class and its data are deleted." },
        ...refusals(...keyed, "storage-full"),
      },
    },
  },
  "/api/v1/classes/{id}/lesson": {
    parameters: ofClass,
    get: {
      operationId: "readLesson",
      summary: "Read the lesson of the class",
      security: anyMember,
      parameters: parameters("header", ifNoneMatchHeader),
      responses: {
        200: answer("The lesson.", challengeOrLessonSchema, entityTag),
        304: { description: "The cached lesson is current.", headers: entityTag },
        ...refusals(...keyed),
      },
    },
    put: {
      operationId: "sendLesson",
      summary: "Send another lesson to the class",
      security: teacher,
      requestBody: body(challengeOrLessonSchema),
      responses: {
        204: { description: "The lesson is stored.", headers: entityTag },
        ...refusals(...keyed, "too-large", "not-json", "storage-full"),
      },
    },
  },
  "/api/v1/classes/{id}/pause": {
    parameters: ofClass,
    put: {
      operationId: "pauseClass",
      summary: "Pause all students",
      description: "The pause ends by the relay's clock. It replaces a running pause.",
      security: teacher,
      requestBody: body(pauseRequestSchema),
      responses: { ...stored, ...refusals(...keyed, "too-large", "not-json", "storage-full") },
    },
    delete: {
      operationId: "resumeClass",
      summary: "End the pause",
      security: teacher,
      responses: { ...stored, ...refusals(...keyed, "storage-full") },
    },
  },
  "/api/v1/classes/{id}/pace": {
    parameters: ofClass,
    put: {
      operationId: "setPace",
      summary: "Open the tasks up to a number",
      security: teacher,
      requestBody: body(paceSchema),
      responses: { ...stored, ...refusals(...keyed, "too-large", "not-json", "storage-full") },
    },
    delete: {
      operationId: "openAllTasks",
      summary: "Open all tasks",
      security: teacher,
      responses: { ...stored, ...refusals(...keyed, "storage-full") },
    },
  },
  "/api/v1/classes/{id}/lock": {
    parameters: ofClass,
    put: {
      operationId: "lockClass",
      summary: "Admit no more students",
      description: "The class also locks when as many students have joined as expected.",
      security: teacher,
      responses: { ...stored, ...refusals(...keyed, "storage-full") },
    },
    delete: {
      operationId: "unlockClass",
      summary: "Admit students again",
      security: teacher,
      responses: { ...stored, ...refusals(...keyed, "storage-full") },
    },
  },
  "/api/v1/classes/{id}/code": {
    parameters: ofClass,
    post: {
      operationId: "replaceClassCode",
      summary: "Replace the code of the class",
      description: "The previous code is invalid from then on.",
      security: teacher,
      responses: {
        201: answer("The new code.", classCodeSchema),
        ...refusals(...keyed, "storage-full"),
      },
    },
  },
  "/api/v1/classes/{id}/students/{student}": {
    parameters: ofStudent,
    delete: {
      operationId: "removeStudent",
      summary: "Remove a student with all data of the student",
      security: teacher,
      responses: {
        204: { description: "The student and the data are deleted." },
        ...refusals(...keyed, "no-student", "storage-full"),
      },
    },
  },
  "/api/v1/classes/{id}/students/{student}/program": {
    parameters: ofStudent,
    get: {
      operationId: "readStudentProgram",
      summary: "Read the newest program of a student",
      security: teacher,
      responses: {
        200: answer("The program.", studentProgramSchema),
        ...refusals(...keyed, "no-student", "no-program"),
      },
    },
  },
  "/api/v1/classes/{id}/students/{student}/return": {
    parameters: ofStudent,
    post: {
      operationId: "createReturnCode",
      summary: "Create a code by which another device becomes this student",
      description:
        "The code is valid for 10 minutes and one device, also while the class is locked. An earlier return code of the " +
        "student becomes invalid. When it is used, the student's previous key becomes invalid.",
      security: teacher,
      responses: {
        201: answer("The code.", returnCodeSchema),
        ...refusals(...keyed, "no-student", "storage-full"),
      },
    },
  },
};
