/** The response to the registration of a robot, and the formats of ids and keys. */
import { z } from "zod";

/** 128 random bits as 22 characters of base64url. */
export const robotIdSchema = z
  .string({ error: "the 22 characters of a robot's id" })
  .regex(/^[A-Za-z0-9_-]{22}$/, { error: "the 22 characters of a robot's id" });

/**
 * A bearer key: a prefix that names its kind, then 128 random bits. The schema checks only its
 * length.
 */
export const keySchema = z
  .string({ error: "a key of this robot" })
  .min(1, { error: "a key of this robot" })
  .max(64, { error: "a key of at most 64 characters" });

export const registrationSchema = z.strictObject({
  id: robotIdSchema,
  /** authorises the page to own this robot; never leaves the page */
  ownerKey: keySchema,
  /** authorises scripts to drive this robot */
  driverKey: keySchema,
  /** everything that a script needs: `https://HOST/r/ID#DRIVERKEY` */
  address: z.url({ error: "a web address" }).max(300),
});
export type Registration = z.infer<typeof registrationSchema>;
