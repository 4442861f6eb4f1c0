/** Short links to stored documents. */
import { z } from "zod";
import { PAIRING_LETTERS } from "./pairing.ts";
import { keySchema } from "./registration.ts";

/** Largest body that stores a document, in bytes. */
export const MAX_DOCUMENT_BYTES = 64 * 1024;

/** Lengths of codes, shortest first. The service uses the shortest with a free code. */
export const SHORT_CODE_LENGTHS = [4, 5, 6] as const;

const idError = "the 4 to 6 letters, or the 12 characters, of a short link";
const [min, , max] = SHORT_CODE_LENGTHS;
const code = `[${PAIRING_LETTERS}${PAIRING_LETTERS.toLowerCase()}]{${min},${max}}`;
const shortCode = new RegExp(`^${code}$`);

/**
 * The id of a short link: a code of 4 to 6 consonants in upper or lower case, or 12 characters of
 * base64url (72 random bits) if no code was free.
 */
export const shortLinkIdSchema = z
  .string({ error: idError })
  .regex(new RegExp(`^(?:${code}|[A-Za-z0-9_-]{12})$`), { error: idError });

/** @returns the code in upper case; null for any other text */
export function readShortCode(id: string): string | null {
  return shortCode.test(id) ? id.toUpperCase() : null;
}

export const shortLinkSchema = z.strictObject({
  id: shortLinkIdSchema,
  /** the link to share: `https://HOST/m/ID` */
  address: z.url({ error: "a web address" }).max(300),
  /** authorises deleting the document; only its creator receives it */
  deleteKey: keySchema,
});
export type ShortLink = z.infer<typeof shortLinkSchema>;

/** Number of the newest links that a device stores so that it can delete them. */
export const MAX_STORED_LINKS = 200;
export const storedLinksSchema = z.array(shortLinkSchema).max(MAX_STORED_LINKS);
