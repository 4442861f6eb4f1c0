/** Reads a lesson that the teacher typed or pasted: a link, a short link of this service, or its text. */
import { readShortLink } from "../../../model/address/short-link.ts";
import { readLessonAddress, type OpenedLesson } from "./read-lesson.ts";

/** Interval of requests while the service delays short links. */
const WAIT_MS = 1_000;

export async function readTypedLesson(text: string): Promise<OpenedLesson> {
  return readLessonAddress(text, location.host, async (id) =>
    readShortLink(
      id,
      (url) => fetch(url),
      async () => new Promise((resolve) => setTimeout(resolve, WAIT_MS)),
    ),
  );
}
