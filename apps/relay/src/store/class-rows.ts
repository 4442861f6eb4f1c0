/** The rows of a class as JSON, as every store holds them. */
import { z } from "zod";
import type { ClassRow, StudentRow } from "./class-store.ts";

export const classRow = z.object({
  version: z.int(),
  n: z.int(),
  stream: z.string(),
  createdAt: z.number(),
  names: z.array(z.string()).nullable(),
  expected: z.int().nullable(),
  keys: z.array(z.object({ kind: z.enum(["teach", "show"]), hash: z.string() })),
  code: z.string(),
  isLocked: z.boolean(),
  pause: z.object({ startedAt: z.number(), endsAt: z.number() }).nullable(),
  pausedMs: z.number(),
  paceTo: z.int().nullable(),
  lessonVersion: z.string(),
  lastStudent: z.int(),
});

export const studentRow = z.object({
  student: z.int(),
  name: z.int(),
  renamesLeft: z.int(),
  key: z.string(),
  joinedAt: z.number(),
  helpSince: z.number().nullable(),
  progress: z.int(),
  programs: z.int(),
  returnCode: z.object({ hash: z.string(), endsAt: z.number() }).nullable(),
});

/** @throws Error if the text is not a class */
export function classRowIn(text: string): ClassRow {
  return classRow.parse(JSON.parse(text));
}

/** @throws Error if the text is not a student */
export function studentRowIn(text: string): StudentRow {
  return studentRow.parse(JSON.parse(text));
}
