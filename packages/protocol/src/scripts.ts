/**
 * Scripts as the robot's owner sees them. Several scripts may share one key: the key together with
 * the name identifies a script, or the key and the language if the script sends no name.
 */
import { z } from "zod";
import { recordActionSchema } from "./command.ts";
import { keyIdSchema } from "./keys.ts";

/** Displayed characters of a name; longer names are truncated. */
export const MAX_SCRIPT_NAME = 40;
/** Longest name that a script may send, in characters. */
export const MAX_SENT_NAME = 200;
/** Scripts of one robot in the owner's list. */
export const MAX_SCRIPTS = 16;
/**
 * Scripts of one robot that can be blocked at a time. To exclude more, the owner replaces the key.
 */
export const MAX_BLOCKED_SCRIPTS = 16;

const nameError = `a name of at most ${MAX_SENT_NAME} characters`;
/** A name as a script sends it; `scriptName` makes it displayable. */
export const sentNameSchema = z
  .string({ error: nameError })
  .max(MAX_SENT_NAME, { error: nameError });

/** @returns the name on one line without invisible characters; null if it is empty then */
export function scriptName(sent: string): string | null {
  const visible = sent.slice(0, MAX_SENT_NAME).replaceAll(/\p{C}/gu, " ").replaceAll(/\s+/gu, " ");
  const name = Array.from(visible.trim()).slice(0, MAX_SCRIPT_NAME).join("").trim();
  return name === "" ? null : name;
}

/** Longest sentence of a script's last problem, in characters; the list of scripts is one message. */
export const MAX_PROBLEM_TEXT = 250;

const idError = "the 8 characters of a script's id";
export const scriptIdSchema = z
  .string({ error: idError })
  .regex(/^[A-Za-z0-9_-]{8}$/, { error: idError });

const identity = {
  /** id of its key */
  driver: keyIdSchema,
  /** the name that the script sent; null if it sent none */
  name: z
    .string({ error: "a name, or null" })
    .min(1, { error: "a name, or null" })
    .max(2 * MAX_SCRIPT_NAME, { error: `a name of at most ${MAX_SCRIPT_NAME} characters` })
    .nullable(),
  /** its language, such as "Python"; "Script" if unknown */
  client: z.string({ error: "a language" }).max(40, { error: "a language" }),
};

/** Identifies a script in a request of the owner. */
export const scriptRefSchema = z.strictObject(identity);
export type ScriptRef = z.infer<typeof scriptRefSchema>;

/** A script and its latest activity. */
export const scriptSchema = z.strictObject({
  id: scriptIdSchema,
  ...identity,
  /** its open connections and event streams */
  connections: z.int().min(0),
  /** ms since its last message; null if this relay has received none */
  silentMs: z.int().min(0).nullable(),
  /** its newest command; null if it only reads */
  last: z.strictObject({ seq: z.int().min(1), action: recordActionSchema }).nullable(),
  /**
   * why the relay last refused a command of this script, as a sentence, and when; null: it refused
   * none, or the script is blocked. Updated at most once a second
   */
  lastProblem: z
    .strictObject({ detail: z.string().max(MAX_PROBLEM_TEXT), at: z.iso.datetime() })
    .nullable(),
  /** whether the owner blocked it: the relay rejects its requests until the owner unblocks it */
  isBlocked: z.boolean(),
});
export type ScriptView = z.infer<typeof scriptSchema>;

export const scriptListSchema = z.strictObject({
  /** whether remote driving is paused: the relay refuses all commands except `stop` */
  paused: z.boolean(),
  /** whether scripts may reset the robot; otherwise the relay refuses `reset` */
  mayReset: z.boolean(),
  scripts: z.array(scriptSchema).max(MAX_SCRIPTS + MAX_BLOCKED_SCRIPTS),
});
export type ScriptList = z.infer<typeof scriptListSchema>;

/** The response to a block request; `id` unblocks the script. */
export const blockedScriptSchema = scriptRefSchema.extend({ id: scriptIdSchema });
export type BlockedScript = z.infer<typeof blockedScriptSchema>;
