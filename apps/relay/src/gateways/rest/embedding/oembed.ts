/** Describes a short link to a site that embeds it, as in https://oembed.com. */
import { frameMarkup, frameSizes, shortLinkIdSchema } from "@corridor/protocol";
import { z } from "zod";
import type { SharedDocument } from "../../../short-links/document-schema.ts";

const MAX_URL_LENGTH = 300;
const MAX_SIDE = 10_000;
const PROVIDER = "Corridor";

const urlError = "the address of a short link of this service, such as https://HOST/m/BCDF";
const formatError = '"json", the only format of this service';
const sideError = `a whole number from 1 to ${MAX_SIDE}`;
const side = z
  .string({ error: sideError })
  .regex(/^\d{1,5}$/, { error: sideError })
  .transform(Number)
  .pipe(z.int().min(1, { error: sideError }).max(MAX_SIDE, { error: sideError }));

export const oembedQuery = z.object({
  url: z.string({ error: urlError }).min(1, { error: urlError }).max(MAX_URL_LENGTH, {
    error: urlError,
  }),
  maxwidth: side.optional().describe("largest width of the frame in pixels"),
  maxheight: side.optional().describe("largest height of the frame in pixels"),
  format: z.literal("json", { error: formatError }).optional(),
});
export type OembedQuery = z.infer<typeof oembedQuery>;

export const oembedSchema = z.strictObject({
  version: z.literal("1.0"),
  type: z.literal("rich"),
  provider_name: z.literal(PROVIDER),
  provider_url: z.url(),
  /** the name of the maze or lesson */
  title: z.string().max(200),
  width: z.int().min(1),
  height: z.int().min(1),
  /** an `iframe` element */
  html: z.string(),
});
export type Oembed = z.infer<typeof oembedSchema>;

/** A short link as other sites write it. */
export interface EmbeddedLink {
  id: string;
  /** "?lang=de" or "" */
  search: string;
}

/**
 * @param origin of this service
 * @returns null if the address is not that of a short link of this service
 */
export function readEmbeddedLink(url: string, origin: string): EmbeddedLink | null {
  if (!URL.canParse(url)) return null;
  const { origin: named, pathname, searchParams } = new URL(url);
  const [, , id = ""] = /^\/(embed\/)?m\/([^/]+)\/?$/.exec(pathname) ?? [];
  if (named !== origin || !shortLinkIdSchema.safeParse(id).success) return null;
  const lang = searchParams.get("lang") ?? "";
  return { id, search: /^[A-Za-z-]{2,10}$/.test(lang) ? `?lang=${lang}` : "" };
}

/** @param document behind the short link */
export function describeFrame(
  { id, search }: EmbeddedLink,
  document: SharedDocument,
  origin: string,
  { maxwidth, maxheight }: Pick<OembedQuery, "maxwidth" | "maxheight">,
): Oembed {
  const { width, height } = frameSizes.medium;
  const frame = {
    address: `${origin}/embed/m/${id}${search}`,
    title: nameOf(document) || PROVIDER,
    width: Math.min(width, maxwidth ?? width),
    height: Math.min(height, maxheight ?? height),
  };
  return {
    version: "1.0",
    type: "rich",
    provider_name: PROVIDER,
    provider_url: origin,
    title: frame.title,
    width: frame.width,
    height: frame.height,
    html: frameMarkup(frame),
  };
}

function nameOf(document: SharedDocument): string {
  return document.format === "corridor/project" ? document.maze.name : document.name;
}
