/**
 * Events for dashboards, without their numbers, as relays exchange them and hold them in memory.
 */
import { progressRecordSchema, studentNumberSchema, studentViewSchema } from "@corridor/protocol";
import { z } from "zod";

export const classRecordSchema = z.discriminatedUnion("type", [
  /** a student joined or changed, with a new progress record */
  z.object({
    type: z.literal("student"),
    student: studentViewSchema,
    progress: progressRecordSchema.nullable(),
  }),
  z.object({ type: z.literal("removed"), student: studentNumberSchema }),
  /** the settings changed: each reader receives the current ones */
  z.object({ type: z.literal("settings") }),
]);
export type ClassRecord = z.infer<typeof classRecordSchema>;
