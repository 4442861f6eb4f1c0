/**
 * A shared challenge as the device stores it: the text of its link. Ten large mazes take 173
 * characters there, and almost 1 MB as JSON.
 */
import {
  lessonOf,
  oldestDocumentOf,
  readChallenge,
  type ChallengeDocument,
} from "@corridor/challenge";
import { decodeLink, encodeLink } from "@corridor/link";

/** @returns null if the challenge does not fit into a link */
export function writeChallengeText(challenge: ChallengeDocument): string | null {
  const link = encodeLink({ lesson: lessonOf(challenge) });
  return link.ok ? link.text : null;
}

/**
 * @returns null if the text is neither a challenge link nor a challenge as JSON, the format of
 *   earlier versions
 */
export function readChallengeText(text: string): ChallengeDocument | null {
  if (text.startsWith("{")) {
    const read = readChallenge(text);
    return read.ok ? read.value : null;
  }
  const link = decodeLink(text);
  if (!link.ok || link.value.lesson === undefined) return null;
  const document = oldestDocumentOf(link.value.lesson);
  return document.version === 1 ? document : null;
}
