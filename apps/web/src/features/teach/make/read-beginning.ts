/** Reads what a teacher begins with: a lesson, or a maze for the first task of one. */
import { readMaze } from "@corridor/maze";
import type { TextFile } from "../../../ui/incoming-files.ts";
import { lessonOfMaze } from "../lessons/new-lesson.ts";
import { lessonOfShared, readLessonFile, type OpenedLesson } from "../lessons/read-lesson.ts";
import { readTyped } from "../lessons/read-typed-lesson.ts";

export interface BeginningResult {
  opened: OpenedLesson;
  /** whether the lesson was shared as it is, not made of a maze */
  isShared: boolean;
}

/**
 * Reads a link, a short link, or the text of a document.
 * @param task name of the task in a maze
 */
export async function readBeginning(text: string, task: string): Promise<BeginningResult> {
  const shared = await readTyped(text);
  const lesson = shared.ok ? lessonOfMaze(shared.content, task) : null;
  if (lesson !== null) return { opened: { ok: true, lesson }, isShared: false };
  return orOfMaze(lessonOfShared(shared), text, task);
}

/** Reads a file. @param task name of the task in a maze */
export async function readBeginningFile(file: TextFile, task: string): Promise<BeginningResult> {
  const opened = await readLessonFile(file);
  const isDocument = !opened.ok && opened.code === "document";
  return orOfMaze(opened, isDocument ? await file.text() : "", task);
}

/** The lesson or, if the document is none, that of the maze in its text. */
function orOfMaze(opened: OpenedLesson, text: string, task: string): BeginningResult {
  if (!opened.ok && opened.code === "document") {
    const read = readMaze(text.replace(/^\uFEFF/, "").trim());
    const lesson = read.ok ? lessonOfMaze({ maze: read.value }, task) : null;
    if (lesson !== null) return { opened: { ok: true, lesson }, isShared: false };
  }
  return { opened, isShared: true };
}
