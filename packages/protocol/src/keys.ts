/** Keys of a robot, which its owner makes and revokes: one drives, the other only watches. */
import { z } from "zod";
import { keySchema } from "./registration.ts";

/** Keys of one robot, with the owner's own: enough for a class, few enough to look through. */
export const MAX_KEYS = 12;

const idError = "the 6 characters of a key's id";
/** Names a key without giving it away: the beginning of its hash, as logs and `driver` show it. */
export const keyIdSchema = z
  .string({ error: idError })
  .regex(/^[A-Za-z0-9_-]{6}$/, { error: idError });

const replaceError = "true, false or the 6 characters of a key's id";
const madeKinds = ["drive", "watch"] as const;

/** What the owner asks for. */
export const keyRequestSchema = z.strictObject({
  /** drive: sends commands and reads; watch: reads only */
  kind: z.enum(madeKinds, { error: `one of ${madeKinds.join(", ")}` }),
  /** true: revokes all earlier keys of this kind in the same step; an id: that key of this kind alone */
  replace: z.union([z.boolean(), keyIdSchema], { error: replaceError }).optional(),
});
export type KeyRequest = z.infer<typeof keyRequestSchema>;

/** The only answer that ever shows the key: the service keeps its hash. */
export const createdKeySchema = z.strictObject({
  id: keyIdSchema,
  kind: z.enum(madeKinds),
  key: keySchema,
  /** all that a script needs: `https://HOST/r/ID#KEY` */
  address: z.url({ error: "a web address" }).max(300),
});
export type CreatedKey = z.infer<typeof createdKeySchema>;

export const keyListSchema = z.strictObject({
  keys: z
    .array(
      z.strictObject({
        id: keyIdSchema,
        kind: z.enum(["own", ...madeKinds]),
        createdAt: z.iso.datetime(),
        /** to about a minute; null: never */
        lastUsedAt: z.iso.datetime().nullable(),
      }),
    )
    .max(MAX_KEYS),
});
export type KeyList = z.infer<typeof keyListSchema>;
