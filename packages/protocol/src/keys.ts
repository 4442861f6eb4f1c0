/**
 * Keys of a robot, which its owner creates and revokes. A key either drives or only watches. A key
 * for URLs is accepted in the path of a gateway and nowhere else, because URLs end up in logs.
 */
import { z } from "zod";
import { keySchema } from "./registration.ts";

/** Maximum number of keys of one robot, including the owner key. */
export const MAX_KEYS = 12;

const idError = "the 6 characters of a key's id";
/**
 * Identifies a key without revealing it: the first characters of its hash, as in logs and `driver`.
 */
export const keyIdSchema = z
  .string({ error: idError })
  .regex(/^[A-Za-z0-9_-]{6}$/, { error: idError });

const replaceError = "true, false or the 6 characters of a key's id";
const createdKinds = ["drive", "watch"] as const;

/** What a key is for: the URL of a client that cannot send a key in another way. */
const keyUse = z.literal("url", { error: '"url"' });

/** The owner's request for a new key. */
export const keyRequestSchema = z.strictObject({
  /** drive: sends commands and reads; watch: reads only */
  kind: z.enum(createdKinds, { error: `one of ${createdKinds.join(", ")}` }),
  /** url: a key for the path of a gateway's URL; without it, a key for scripts or viewers */
  use: keyUse.optional(),
  /**
   * true: atomically revokes all earlier keys of this kind and use; an id: revokes only that key of
   * this kind and use
   */
  replace: z.union([z.boolean(), keyIdSchema], { error: replaceError }).optional(),
});
export type KeyRequest = z.infer<typeof keyRequestSchema>;

const url = z.url({ error: "a web address" }).max(300);

/** The only response that contains the key: the service stores its hash. */
export const createdKeySchema = z.strictObject({
  id: keyIdSchema,
  kind: z.enum(createdKinds),
  key: keySchema,
  /** everything that a script needs: `https://HOST/r/ID#KEY`; null for a key for URLs */
  address: url.nullable(),
  /**
   * the URL of each gateway with this key, null if the gateway is off; null for other keys
   */
  urls: z.strictObject({ ros: url.nullable(), mcp: url.nullable() }).nullable(),
});
export type CreatedKey = z.infer<typeof createdKeySchema>;

export const keyListSchema = z.strictObject({
  keys: z
    .array(
      z.strictObject({
        id: keyIdSchema,
        kind: z.enum(["own", ...createdKinds]),
        /** url: a key for URLs; null for other keys */
        use: keyUse.nullable(),
        createdAt: z.iso.datetime(),
        /** accurate to about a minute; null: never */
        lastUsedAt: z.iso.datetime().nullable(),
      }),
    )
    .max(MAX_KEYS),
});
export type KeyList = z.infer<typeof keyListSchema>;
