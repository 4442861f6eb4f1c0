/** What the service answers when it has stored a document under a short link. */
import { z } from "zod";
import { PAIRING_LETTERS } from "./pairing.ts";
import { keySchema } from "./registration.ts";

/** Largest body that stores a maze, program or challenge, in bytes. */
export const MAX_DOCUMENT_BYTES = 64 * 1024;

/** Lengths of the codes that the service gives, shortest first: the shortest free one is used. */
export const SHORT_CODE_LENGTHS = [4, 5, 6] as const;

const idError = "the 4 to 6 letters of a short link, or the 12 characters of an older one";
const [least, , most] = SHORT_CODE_LENGTHS;
const code = `[${PAIRING_LETTERS}${PAIRING_LETTERS.toLowerCase()}]{${least},${most}}`;
const shortCode = new RegExp(`^${code}$`);

/**
 * The id of a short link: a code of 4 to 6 consonants in capital or small letters, or, of links from before there
 * were codes, 72 random bits as 12 characters of base64url.
 */
export const shortLinkIdSchema = z
  .string({ error: idError })
  .regex(new RegExp(`^(?:${code}|[A-Za-z0-9_-]{12})$`), { error: idError });

/** @returns the code in capital letters; null for an older id, which cannot be guessed, and for anything else */
export function readShortCode(id: string): string | null {
  return shortCode.test(id) ? id.toUpperCase() : null;
}

export const shortLinkSchema = z.strictObject({
  id: shortLinkIdSchema,
  /** what is passed on: `https://HOST/m/ID` */
  address: z.url({ error: "a web address" }).max(300),
  /** deletes the document; whoever stored it has one, and nobody else */
  deleteKey: keySchema,
});
export type ShortLink = z.infer<typeof shortLinkSchema>;

/** The links that one device has made and can delete: the newest ones. */
export const MAX_STORED_LINKS = 200;
export const storedLinksSchema = z.array(shortLinkSchema).max(MAX_STORED_LINKS);
