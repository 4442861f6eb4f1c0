/** What relays that serve the same class send each other besides commits. */
import { studentNumberSchema, tileSchema } from "@corridor/protocol";
import { z } from "zod";

/** The connections of a class at one relay. */
const classPresenceSchema = z.object({
  /** connected students, and when each of them connected */
  students: z.array(z.object({ student: studentNumberSchema, connectedAt: z.number() })),
  /** students whom a dashboard watches */
  watched: z.array(studentNumberSchema),
  /** numbers of connections */
  dashboards: z.int(),
  screens: z.int(),
});
export type ClassPresence = z.infer<typeof classPresenceSchema>;

export const classMessageSchema = z.discriminatedUnion("kind", [
  /** replaces the earlier presence of that relay; `asks` requests tiles and display */
  z.object({ kind: z.literal("here"), presence: classPresenceSchema, asks: z.boolean() }),
  /** newest tiles of students who are connected there */
  z.object({
    kind: z.literal("tiles"),
    tiles: z.array(z.object({ student: studentNumberSchema, tile: tileSchema })),
  }),
  z.object({
    kind: z.literal("hint"),
    student: studentNumberSchema,
    task: z.int(),
    hint: z.int(),
  }),
  /** what big screens show; not new: for a relay that has none yet */
  z.object({
    kind: z.literal("display"),
    content: z.looseObject({}),
    isNew: z.boolean(),
    /** null: any content replaces it */
    priority: z.int().nullable(),
  }),
  /** the dashboard whose content has this priority has closed */
  z.object({ kind: z.literal("released"), priority: z.int() }),
]);
export type ClassMessage = z.infer<typeof classMessageSchema>;
