/**
 * Scripts as the owner of a robot knows them. Several may share one key, so a script is told apart by its
 * key and the name that it gives itself; one without a name, by its key and its language.
 */
import { z } from "zod";
import { actionNames } from "./command.ts";
import { keyIdSchema } from "./keys.ts";

/** Characters of a name that are shown; the rest is left out. */
export const MAX_SCRIPT_NAME = 40;
/** Characters of what a script may send as its name. */
const MAX_SENT_NAME = 200;
/** Scripts of one robot that its owner is told of. */
export const MAX_SCRIPTS = 16;
/** Scripts of one robot that may be sent away at a time: beyond that, a new key is the better means. */
export const MAX_BLOCKED_SCRIPTS = 16;

const nameError = `a name of at most ${MAX_SENT_NAME} characters`;
/** A name as a script sends it; `scriptName` makes of it what is shown. */
export const sentNameSchema = z
  .string({ error: nameError })
  .max(MAX_SENT_NAME, { error: nameError });

/** A name as it may be shown: one line, nothing invisible in it. Null where nothing is left. */
export function scriptName(sent: string): string | null {
  const visible = sent.slice(0, MAX_SENT_NAME).replaceAll(/\p{C}/gu, " ").replaceAll(/\s+/gu, " ");
  const name = Array.from(visible.trim()).slice(0, MAX_SCRIPT_NAME).join("").trim();
  return name === "" ? null : name;
}

const idError = "the 8 characters of a script's id";
export const scriptIdSchema = z
  .string({ error: idError })
  .regex(/^[A-Za-z0-9_-]{8}$/, { error: idError });

const who = {
  /** id of the key that it uses */
  driver: keyIdSchema,
  /** as it calls itself; null where it gives no name */
  name: z
    .string({ error: "a name, or null" })
    .min(1, { error: "a name, or null" })
    .max(2 * MAX_SCRIPT_NAME, { error: `a name of at most ${MAX_SCRIPT_NAME} characters` })
    .nullable(),
  /** its language, such as "Python"; "Script" where it is not known */
  client: z.string({ error: "a language" }).max(40, { error: "a language" }),
};

/** Which script the owner means. */
export const scriptRefSchema = z.strictObject(who);
export type ScriptRef = z.infer<typeof scriptRefSchema>;

/** A script, and what it did last. */
export const scriptSchema = z.strictObject({
  id: scriptIdSchema,
  ...who,
  /** its open connections and event streams */
  connections: z.int().min(0),
  /** ms since it was last heard; null while it was not heard by this relay */
  silentMs: z.int().min(0).nullable(),
  /** the newest command that it sent; null where it only reads */
  last: z.strictObject({ seq: z.int().min(1), action: z.enum(actionNames) }).nullable(),
  /** its owner has sent it away: nothing of it is taken until it is let back */
  isBlocked: z.boolean(),
});
export type ScriptView = z.infer<typeof scriptSchema>;

export const scriptListSchema = z.strictObject({
  /** remote driving is paused: commands are refused, all but a stop */
  paused: z.boolean(),
  scripts: z.array(scriptSchema).max(MAX_SCRIPTS + MAX_BLOCKED_SCRIPTS),
});
export type ScriptList = z.infer<typeof scriptListSchema>;

/** The answer when a script was sent away: by this id it is let back. */
export const blockedScriptSchema = scriptRefSchema.extend({ id: scriptIdSchema });
export type BlockedScript = z.infer<typeof blockedScriptSchema>;
