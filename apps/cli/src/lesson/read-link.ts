/** Reads shared links. Nothing is fetched: a link contains its documents. */
import { decodeLink, type LinkContent } from "@corridor/link";
import { problem, type ReadResult } from "@corridor/protocol";

/**
 * Returns the content of a link.
 * @param text complete address with `#`, or the text after `#`
 */
export function readLink(text: string): ReadResult<LinkContent> {
  const hash = text.indexOf("#");
  if (hash < 0 && text.includes("/")) {
    return problem(
      "link",
      "an address without #",
      "the complete link, with the text after #: a short link is not fetched",
    );
  }
  return decodeLink(text.slice(hash + 1));
}
