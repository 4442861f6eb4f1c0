/** Saves a lesson with which a teacher begins, and finds the maze that was open last. */
import { lessonMark, type LessonDocument } from "@corridor/challenge";
import { readProject } from "../../../model/projects/read-project.ts";
import { ProjectStorage, type Project } from "../../../model/projects/project-storage.ts";
import type { KeyValueStorage } from "../../../model/storage/key-value-storage.ts";
import { newTextId } from "../../../model/storage/new-text-id.ts";
import type { SavedLessons } from "../../../model/teaching/saved-lessons.ts";

/** `full`: the device has as many lessons as it saves; `blocked`: its storage is full or forbidden. */
export type Begun = { ok: true; id: string } | { ok: false; code: "full" | "blocked" };

/** Saves a lesson as a new one. */
export function beginLesson(lessons: SavedLessons, lesson: LessonDocument): Begun {
  if (lessons.isFull) return { ok: false, code: "full" };
  const id = newTextId();
  try {
    lessons.write({
      id,
      savedAt: Date.now(),
      revision: newTextId(),
      lesson,
      solutions: new Map(),
    });
  } catch {
    return { ok: false, code: "blocked" };
  }
  return { ok: true, id };
}

/** Opens the saved lesson with exactly this content, so that a link that opens twice has one copy. */
export function beginShared(lessons: SavedLessons, lesson: LessonDocument): Begun {
  const mark = lessonMark(lesson);
  const same = lessons.list().find((each) => lessonMark(each.lesson) === mark);
  return same === undefined ? beginLesson(lessons, lesson) : { ok: true, id: same.id };
}

/** The maze that was open last in the student's page of this device; null without one. */
export function openMaze(device: KeyValueStorage): Project["maze"] | null {
  return new ProjectStorage(device, () => readProject).list()[0]?.maze ?? null;
}
