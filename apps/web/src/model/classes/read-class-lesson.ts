/** Reads the lesson of the class from the relay, with the key of the student. */
import { readLesson, type LessonDocument } from "@corridor/challenge";
import type { JoinedClass } from "@corridor/protocol";

/** The part of fetch that is used. */
export type ReadUrl = (
  url: string,
  request: { headers: Record<string, string> },
) => Promise<Pick<Response, "ok" | "text">>;

export type ClassLessonResult =
  | { ok: true; lesson: LessonDocument }
  /** old: the page cannot read the lesson; failed: the relay did not send it */
  | { ok: false; reason: "old" | "failed" };

export async function readClassLesson(
  { class: id, key }: Pick<JoinedClass, "class" | "key">,
  read: ReadUrl,
): Promise<ClassLessonResult> {
  try {
    const headers = { Authorization: `Bearer ${key}` };
    const answer = await read(`/api/v1/classes/${id}/lesson`, { headers });
    if (!answer.ok) return { ok: false, reason: "failed" };
    const lesson = readLesson(await answer.text());
    return lesson.ok ? { ok: true, lesson: lesson.value } : { ok: false, reason: "old" };
  } catch {
    return { ok: false, reason: "failed" };
  }
}
