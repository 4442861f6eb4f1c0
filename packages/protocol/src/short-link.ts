/** What the service answers when it has stored a document under a short link. */
import { z } from "zod";
import { keySchema } from "./registration.ts";

/** Largest body that stores a maze, program or challenge, in bytes. */
export const MAX_DOCUMENT_BYTES = 64 * 1024;

const idError = "the 12 characters of a short link's id";

/** 72 random bits as 12 characters of base64url. */
export const shortLinkIdSchema = z.string({ error: idError }).regex(/^[A-Za-z0-9_-]{12}$/, {
  error: idError,
});

export const shortLinkSchema = z.strictObject({
  id: shortLinkIdSchema,
  /** what is passed on: `https://HOST/m/ID` */
  address: z.url({ error: "a web address" }).max(300),
  /** deletes the document; whoever stored it has one, and nobody else */
  deleteKey: keySchema,
});
export type ShortLink = z.infer<typeof shortLinkSchema>;

/** The links that one device has made and can delete: the newest ones. */
export const MAX_KEPT_LINKS = 200;
export const keptLinksSchema = z.array(shortLinkSchema).max(MAX_KEPT_LINKS);
