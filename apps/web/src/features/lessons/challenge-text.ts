/**
 * A shared challenge as the device keeps it: the text of its link, since ten large mazes are 173
 * characters there and most of a megabyte as JSON.
 */
import { readChallenge, type ChallengeDocument } from "@corridor/challenge";
import { decodeLink, encodeLink } from "@corridor/link";

/** @returns null for a challenge that no link can carry */
export function writeChallengeText(challenge: ChallengeDocument): string | null {
  const link = encodeLink({ challenge });
  return link.ok ? link.text : null;
}

/** @returns null where the text is no challenge, neither a link's nor, as it once was kept, JSON */
export function readChallengeText(text: string): ChallengeDocument | null {
  if (text.startsWith("{")) {
    const read = readChallenge(text);
    return read.ok ? read.value : null;
  }
  const link = decodeLink(text);
  return link.ok ? (link.value.challenge ?? null) : null;
}
