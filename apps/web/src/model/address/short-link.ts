/** Loads the document of a short link, and parses it as strictly as any file. */
import { readLesson } from "@corridor/challenge/document";
import type { LessonDocument } from "@corridor/challenge";
import { readProject } from "@corridor/link/project";
import { readMaze, type MazeDocument } from "@corridor/maze";
import { readProgram, type ProgramDocument } from "@corridor/program";
import { MAX_DOCUMENT_BYTES, shortLinkIdSchema, type ReadResult } from "@corridor/protocol";

/** A maze, a program or both, or a lesson. */
export interface ShortLinkContent {
  maze?: MazeDocument;
  program?: ProgramDocument;
  lesson?: LessonDocument;
}

export type ShortLinkResult =
  | { ok: true; value: ShortLinkContent }
  /** the message to display, as a translation key */
  | { ok: false; sentence: "share.shortLink.gone" | "share.linkProblems.unknown-version" }
  /** too many wrong codes came from this network: the same link may open later */
  | { ok: false; sentence: "share.shortLink.wait" };

/** The part of a Response that is used. */
interface Answer {
  ok: boolean;
  status: number;
  text: () => Promise<string>;
}

const readers = new Map<string, (text: string) => ReadResult<ShortLinkContent>>([
  ["corridor/maze", (text) => under("maze", readMaze(text))],
  ["corridor/program", (text) => under("program", readProgram(text))],
  ["corridor/project", readMazeAndProgram],
  ["corridor/challenge", (text) => under("lesson", readLesson(text))],
]);

/** Attempts while the service delays checks for this network. */
const MAX_TRIES = 10;

/**
 * @param wait waits a second, which the service requests when too many checks of this network are
 *   pending
 * @throws Error if the service does not respond, or responds with another error
 */
export async function readShortLink(
  id: string,
  get: (url: string) => Promise<Answer>,
  wait: () => Promise<void>,
): Promise<ShortLinkResult> {
  if (!shortLinkIdSchema.safeParse(id).success)
    return { ok: false, sentence: "share.shortLink.gone" };
  let answer = await get(`/api/v1/mazes/${id}`);
  for (let tries = 1; answer.status === 429 && tries < MAX_TRIES; tries++) {
    await wait();
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

/** The service writes the format first, like all Corridor documents. */
function formatOf(text: string): string {
  return /^\{"format":"([a-z/]{1,40})"/.exec(text)?.[1] ?? "";
}

function readMazeAndProgram(text: string): ReadResult<ShortLinkContent> {
  const read = readProject(text);
  if (!read.ok) return read;
  const { maze, program } = read.value;
  return { ok: true, value: { maze, program } };
}

function under<Name extends keyof ShortLinkContent>(
  name: Name,
  read: ReadResult<NonNullable<ShortLinkContent[Name]>>,
): ReadResult<ShortLinkContent> {
  return read.ok ? { ok: true, value: { [name]: read.value } } : read;
}
