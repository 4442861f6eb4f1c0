/** Versions of documents as entity tags (RFC 9110, section 8.8.3), and conditional requests. */
import { z } from "zod";

/** Header of a conditional request. */
export const ifNoneMatchHeader = z.object({
  "If-None-Match": z.string().optional().describe("the `ETag` of the cached document"),
});

export function entityTag(version: string): string {
  return `"${version}"`;
}

/** A proxy that compresses a response marks its tag as weak. */
export function matchesTag(header: string | undefined, tag: string): boolean {
  return (header ?? "").split(",").some((each) => each.trim().replace(/^W\//, "") === tag);
}
