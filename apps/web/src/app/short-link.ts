/** Fetches what a short link leads to, and reads it as strictly as any file. */
import { readChallenge } from "@corridor/challenge/document";
import type { ChallengeDocument } from "@corridor/challenge";
import { readMaze, type MazeDocument } from "@corridor/maze";
import { readProgram, type ProgramDocument } from "@corridor/program";
import { MAX_DOCUMENT_BYTES, shortLinkIdSchema, type ReadResult } from "@corridor/protocol";

/** One of the three. */
export interface ShortLinkContent {
  maze?: MazeDocument;
  program?: ProgramDocument;
  challenge?: ChallengeDocument;
}

export type ShortLinkResult =
  | { ok: true; value: ShortLinkContent }
  /** what is told about it, as a key of the words */
  | { ok: false; sentence: "share.shortLink.gone" | "share.linkProblems.unknown-version" }
  /** too many wrong codes came from this network: the same link may open later */
  | { ok: false; sentence: "share.shortLink.wait" };

/** As much of an answer as is needed. */
interface Answer {
  ok: boolean;
  status: number;
  text: () => Promise<string>;
}

const readers = new Map<string, (text: string) => ReadResult<ShortLinkContent>>([
  ["corridor/maze", (text) => under("maze", readMaze(text))],
  ["corridor/program", (text) => under("program", readProgram(text))],
  ["corridor/challenge", (text) => under("challenge", readChallenge(text))],
]);

/** Tries while the codes of the whole network wait to be checked. */
const MAX_TRIES = 10;

/**
 * @param pause waits a second, which the service asks for when too many codes of the network wait
 * @throws Error when the service does not answer, or not now
 */
export async function readShortLink(
  id: string,
  get: (url: string) => Promise<Answer>,
  pause: () => Promise<void>,
): Promise<ShortLinkResult> {
  if (!shortLinkIdSchema.safeParse(id).success)
    return { ok: false, sentence: "share.shortLink.gone" };
  let answer = await get(`/api/v1/mazes/${id}`);
  for (let tries = 1; answer.status === 429 && tries < MAX_TRIES; tries++) {
    await pause();
    answer = await get(`/api/v1/mazes/${id}`);
  }
  if (answer.status === 404) return { ok: false, sentence: "share.shortLink.gone" };
  if (answer.status === 429) return { ok: false, sentence: "share.shortLink.wait" };
  if (!answer.ok) throw new Error(`The short link was answered with ${answer.status}.`);
  const text = await answer.text();
  const format = text.length > MAX_DOCUMENT_BYTES ? "" : formatOf(text);
  const read = readers.get(format)?.(text);
  if (read?.ok === true) return read;
  return { ok: false, sentence: "share.linkProblems.unknown-version" };
}

/** The service writes the format first, as all that Corridor writes. */
function formatOf(text: string): string {
  return /^\{"format":"([a-z/]{1,40})"/.exec(text)?.[1] ?? "";
}

function under<Name extends keyof ShortLinkContent>(
  name: Name,
  read: ReadResult<NonNullable<ShortLinkContent[Name]>>,
): ReadResult<ShortLinkContent> {
  return read.ok ? { ok: true, value: { [name]: read.value } } : read;
}
