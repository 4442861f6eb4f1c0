/**
 * The lessons of several tasks that this device stores, each once, with its solved tasks. The work on
 * each task is a project. A reference in the place of the project's challenge names its task.
 */
import { lessonMark, type LessonDocument } from "@corridor/challenge";
import type { TaskPlace } from "../challenge/challenge-store.ts";
import { challengeKey } from "../projects/project-storage.ts";
import { keysUnder, type KeyValueStorage } from "../storage/key-value-storage.ts";
import { readLessonText, writeLessonText } from "./lesson-text.ts";

const PREFIX = "corridor.lesson.";
const REFERENCE = /^task ([0-9a-f]{9}) (\d{1,2})$/;

/** The text that a project stores to name its task. */
export function writeReference({ lesson, index }: TaskPlace): string {
  return `task ${lesson} ${index}`;
}

/** @returns null for any other text */
export function readReference(text: string): TaskPlace | null {
  const [, lesson, index] = REFERENCE.exec(text) ?? [];
  return lesson === undefined ? null : { lesson, index: Number(index) };
}

interface StoredLesson {
  /** see `lesson-text.ts` */
  text: string;
  /** indexes of the solved tasks */
  solved: readonly number[];
}

export class StoredLessons {
  readonly #device: KeyValueStorage;
  /** lessons that the device failed to store, by id */
  readonly #pending = new Map<string, StoredLesson>();

  constructor(device: KeyValueStorage) {
    this.#device = device;
  }

  /**
   * Stores a lesson. A lesson that is already stored stays, with its solved tasks.
   * @returns its id, which is its mark, and whether the device stored it
   */
  add(lesson: LessonDocument): { id: string; isStored: boolean } {
    const id = lessonMark(lesson);
    const solved = this.#read(id)?.solved ?? [];
    return { id, isStored: this.#write(id, { text: writeLessonText(lesson), solved }) };
  }

  /** A stored lesson; null if there is none with this id, or it is unreadable. */
  lesson(id: string): LessonDocument | null {
    const text = this.#read(id)?.text;
    return text === undefined ? null : readLessonText(text);
  }

  /** Which tasks of a lesson are solved, by index. */
  solved(id: string, { tasks }: LessonDocument): boolean[] {
    const solved = this.#read(id)?.solved ?? [];
    return tasks.map((_, index) => solved.includes(index));
  }

  /** @returns whether the device stored that the task is solved */
  addSolved({ lesson, index }: TaskPlace): boolean {
    const stored = this.#read(lesson);
    if (stored === null) return false;
    const solved = [...new Set([...stored.solved, index])].toSorted((a, b) => a - b);
    return this.#write(lesson, { ...stored, solved });
  }

  /** Deletes lessons to which no project refers any more. */
  sweep(): void {
    const references = keysUnder(this.#device, challengeKey("")).map(
      (key) => this.#device.getItem(key) ?? "",
    );
    const used = new Set(references.map((text) => readReference(text)?.lesson));
    for (const key of keysUnder(this.#device, PREFIX)) {
      if (!used.has(key.slice(PREFIX.length))) this.#device.removeItem(key);
    }
  }

  #read(id: string): StoredLesson | null {
    return this.#pending.get(id) ?? parse(this.#device.getItem(PREFIX + id));
  }

  #write(id: string, lesson: StoredLesson): boolean {
    try {
      this.#device.setItem(PREFIX + id, JSON.stringify(lesson));
      this.#pending.delete(id);
      return true;
    } catch {
      this.#pending.set(id, lesson);
      return false;
    }
  }
}

function parse(text: string | null): StoredLesson | null {
  let input: unknown;
  try {
    input = JSON.parse(text ?? "null");
  } catch {
    return null;
  }
  if (typeof input !== "object" || input === null) return null;
  const { text: lesson, solved } = input as Record<string, unknown>;
  if (typeof lesson !== "string") return null;
  const numbers = Array.isArray(solved) ? solved : [];
  return { text: lesson, solved: numbers.filter((each) => typeof each === "number") };
}
