/**
 * Pairing: a code of a few letters, typed by hand in place of a long address. The robot's page shows it, a
 * script asks with it, and the page's owner says yes or no.
 */
import { z } from "zod";
import { keyIdSchema } from "./keys.ts";
import { keySchema } from "./registration.ts";
import { sentNameSchema } from "./scripts.ts";

/** Consonants: no code is a word, and none of them is taken for a digit. */
export const PAIRING_LETTERS = "BCDFGHJKLMNPQRSTVWXZ";
export const PAIRING_LENGTH = 8;

/** What somebody types may have spaces and dashes in it, and small letters. */
const MAX_TYPED = 32;

const codeError = `the ${PAIRING_LENGTH} letters of a pairing code, such as BCDF GHJK`;
const letters = `[${PAIRING_LETTERS}${PAIRING_LETTERS.toLowerCase()}]`;
/** A code as it is typed. Read, it is its capital letters alone. */
const pairingCodeSchema = z
  .string({ error: codeError })
  .max(MAX_TYPED, { error: codeError })
  .regex(new RegExp(`^[ -]*(?:${letters}[ -]*){${PAIRING_LENGTH}}$`), { error: codeError })
  .transform((typed) => typed.toUpperCase().replaceAll(/[ -]/g, ""));

const seconds = z.int().min(0);
const endsInSeconds = seconds.describe("until the code counts no more, asked or not");

/** The only answer that ever shows the code: the service keeps its hash. */
export const createdPairingSchema = z.strictObject({
  code: z.string().length(PAIRING_LENGTH).describe("to be typed where the script runs"),
  endsInSeconds,
});
export type CreatedPairing = z.infer<typeof createdPairingSchema>;

/** What a script asks with. */
export const pairingRequestSchema = z.strictObject({
  code: pairingCodeSchema,
  name: sentNameSchema
    .nullish()
    .describe("what the script calls itself, for the owner who is asked; may be left out"),
});

/** The question was put. */
export const requestedPairingSchema = z.strictObject({
  key: keySchema.describe("waits for the answer now, and drives the robot once its owner said yes"),
  endsInSeconds,
});
export type RequestedPairing = z.infer<typeof requestedPairingSchema>;

/** What the script that waits is told. */
export const pairingAnswerSchema = z.strictObject({
  state: z.enum(["asked", "accepted"]).describe("asked: the owner has not answered yet"),
  address: z
    .url({ error: "a web address" })
    .max(300)
    .nullable()
    .describe("all that the script needs, https://HOST/r/ID#KEY; null until the owner said yes"),
  endsInSeconds,
});
export type PairingAnswer = z.infer<typeof pairingAnswerSchema>;

/** What the owner is told of the newest code. */
export const pairingSchema = z.strictObject({
  state: z
    .enum(["none", "open", "asked", "accepted", "refused"])
    .describe("none: no code counts; open: nobody has used it yet"),
  /** the script that asks; null while none did */
  question: z
    .strictObject({
      id: keyIdSchema.describe("of the key that the script gets by a yes"),
      name: z.string().nullable().describe("as it calls itself"),
      client: z.string().describe('its language, such as "Python"'),
    })
    .nullable(),
  endsInSeconds,
});
export type Pairing = z.infer<typeof pairingSchema>;

/** What the owner says. */
export const pairingReplySchema = z.strictObject({
  id: keyIdSchema.describe("of the question"),
  accept: z.boolean({ error: "true or false" }),
});
