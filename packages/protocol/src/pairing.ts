/**
 * Pairing: a short code to type instead of a long address. The robot's page shows the code, a
 * script requests access with it, and the owner accepts or refuses.
 */
import { z } from "zod";
import { keyIdSchema } from "./keys.ts";
import { keySchema } from "./registration.ts";
import { sentNameSchema } from "./scripts.ts";

/** Consonants only: codes form no words, and no letter resembles a digit. */
export const PAIRING_LETTERS = "BCDFGHJKLMNPQRSTVWXZ";
export const PAIRING_LENGTH = 8;

/** Longest typed code, which may contain spaces and hyphens. */
const MAX_TYPED = 32;

const codeError = `the ${PAIRING_LENGTH} letters of a pairing code, such as BCDF GHJK`;
const letters = `[${PAIRING_LETTERS}${PAIRING_LETTERS.toLowerCase()}]`;
/** Accepts a code as typed, and returns only its letters, in upper case. */
const pairingCodeSchema = z
  .string({ error: codeError })
  .max(MAX_TYPED, { error: codeError })
  .regex(new RegExp(`^[ -]*(?:${letters}[ -]*){${PAIRING_LENGTH}}$`), { error: codeError })
  .transform((typed) => typed.toUpperCase().replaceAll(/[ -]/g, ""));

const seconds = z.int().min(0);
const endsInSeconds = seconds.describe(
  "until the code expires, whether a script has used it or not",
);

/** The only response that contains the code: the service stores its hash. */
export const createdPairingSchema = z.strictObject({
  code: z.string().length(PAIRING_LENGTH).describe("to type where the script runs"),
  endsInSeconds,
});
export type CreatedPairing = z.infer<typeof createdPairingSchema>;

/** A script's request for access. */
export const pairingRequestSchema = z.strictObject({
  code: pairingCodeSchema,
  name: sentNameSchema.nullish().describe("the name of the script, which the owner sees; optional"),
});

/** The response to a request for access. */
export const requestedPairingSchema = z.strictObject({
  key: keySchema.describe(
    "authorises waiting for the answer, and driving the robot once its owner has accepted",
  ),
  endsInSeconds,
});
export type RequestedPairing = z.infer<typeof requestedPairingSchema>;

/** The response to a script that waits for the owner's answer. */
export const pairingAnswerSchema = z.strictObject({
  state: z.enum(["asked", "accepted"]).describe("asked: the owner has not answered yet"),
  address: z
    .url({ error: "a web address" })
    .max(300)
    .nullable()
    .describe(
      "everything that the script needs, https://HOST/r/ID#KEY; null until the owner has accepted",
    ),
  endsInSeconds,
});
export type PairingAnswer = z.infer<typeof pairingAnswerSchema>;

/** The state of the newest code, for the owner. */
export const pairingSchema = z.strictObject({
  state: z
    .enum(["none", "open", "asked", "accepted", "refused"])
    .describe("none: there is no valid code; open: no script has used the code yet"),
  /** the script that requests access; null if there is none */
  question: z
    .strictObject({
      id: keyIdSchema.describe("id of the key that the script gets if the owner accepts"),
      name: z.string().nullable().describe("the name that the script sent"),
      client: z.string().describe('its language, such as "Python"'),
    })
    .nullable(),
  endsInSeconds,
});
export type Pairing = z.infer<typeof pairingSchema>;

/** The owner's answer. */
export const pairingReplySchema = z.strictObject({
  id: keyIdSchema.describe("id of the question"),
  accept: z.boolean({ error: "true or false" }),
});
