/** Reads what the teacher typed or pasted: a link, a short link of this service, or a lesson's text. */
import { readShortLink } from "../../../model/address/short-link.ts";
import {
  lessonOfShared,
  readShared,
  type OpenedLesson,
  type SharedContent,
} from "./read-lesson.ts";

/** Interval of requests while the service delays short links. */
const WAIT_MS = 1_000;

export async function readTyped(text: string): Promise<SharedContent> {
  return readShared(text, location.host, async (id) =>
    readShortLink(
      id,
      (url) => fetch(url),
      async () => new Promise((resolve) => setTimeout(resolve, WAIT_MS)),
    ),
  );
}

export async function readTypedLesson(text: string): Promise<OpenedLesson> {
  return lessonOfShared(await readTyped(text));
}
