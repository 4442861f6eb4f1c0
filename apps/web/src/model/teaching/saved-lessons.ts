/**
 * The lessons that a teacher saved on this device, each under its own key, so that two tabs with
 * different lessons never overwrite each other. An entry that cannot be read stays, but is not
 * listed: a later Corridor may read it.
 */
import type { LessonDocument } from "@corridor/challenge";
import { keysUnder, type KeyValueStorage } from "../storage/key-value-storage.ts";
import { readDraft, writeDraft } from "./draft-text.ts";
import { readSolutions, type Solutions } from "./solution.ts";

export interface SavedLesson {
  id: string;
  /** milliseconds since 1970 */
  savedAt: number;
  /** changes with every write, so that a tab notices writes of another one */
  revision: string;
  lesson: LessonDocument;
  solutions: Solutions;
}

/** Maximum number of saved lessons. */
export const MAX_SAVED_LESSONS = 60;

const PREFIX = "corridor.teach.made.";

export class SavedLessons {
  readonly #device: KeyValueStorage;

  constructor(device: KeyValueStorage) {
    this.#device = device;
  }

  /** All readable lessons, newest first. */
  list(): SavedLesson[] {
    return this.#ids()
      .flatMap((id) => this.read(id) ?? [])
      .toSorted((a, b) => b.savedAt - a.savedAt || (a.id < b.id ? -1 : 1));
  }

  /** Whether no further lesson can be saved. */
  get isFull(): boolean {
    return this.#ids().length >= MAX_SAVED_LESSONS;
  }

  /** null if it is missing or unreadable */
  read(id: string): SavedLesson | null {
    const text = this.#device.getItem(PREFIX + id);
    const entry = text === null ? null : parse(text);
    if (entry === null || typeof entry["text"] !== "string") return null;
    const lesson = readDraft(entry["text"]);
    if (lesson === null) return null;
    const { savedAt, revision, solutions } = entry;
    return {
      id,
      savedAt: typeof savedAt === "number" && Number.isFinite(savedAt) ? savedAt : 0,
      revision: typeof revision === "string" ? revision : "",
      lesson,
      solutions: readSolutions(solutions),
    };
  }

  /**
   * Whether writing this lesson overwrites only its own version: its entry has the same revision, or
   * is missing.
   */
  canOverwrite({ id, revision }: Pick<SavedLesson, "id" | "revision">): boolean {
    const text = this.#device.getItem(PREFIX + id);
    return text === null || parse(text)?.["revision"] === revision;
  }

  /** @throws the error of the storage if it is full or forbidden, or a RangeError */
  write({ id, savedAt, revision, lesson, solutions }: SavedLesson): void {
    const entry = { savedAt, revision, text: writeDraft(lesson), solutions: [...solutions] };
    this.#device.setItem(PREFIX + id, JSON.stringify(entry));
  }

  remove(id: string): void {
    this.#device.removeItem(PREFIX + id);
  }

  #ids(): string[] {
    return keysUnder(this.#device, PREFIX).map((key) => key.slice(PREFIX.length));
  }
}

function parse(text: string): Record<string, unknown> | null {
  try {
    const entry: unknown = JSON.parse(text);
    return typeof entry === "object" && entry !== null ? { ...entry } : null;
  } catch {
    return null;
  }
}
