/** What the device stores of the teacher's work: the open lesson and the pasted lines. */
import { oldestDocumentOf, readLesson, type LessonDocument } from "@corridor/challenge";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";

const LESSON_KEY = "corridor.teach.lesson";
const LINES_KEY = "corridor.teach.handins";

export class TeachStorage {
  readonly #device: KeyValueStorage;

  constructor(device: KeyValueStorage) {
    this.#device = device;
  }

  /** The stored lesson; null if there is none. */
  readLesson(): LessonDocument | null {
    const text = this.#device.getItem(LESSON_KEY);
    const read = text === null ? null : readLesson(text);
    return read?.ok === true ? read.value : null;
  }

  storeLesson(lesson: LessonDocument): void {
    this.#store(LESSON_KEY, JSON.stringify(oldestDocumentOf(lesson)));
  }

  readLines(): string {
    return this.#device.getItem(LINES_KEY) ?? "";
  }

  storeLines(text: string): void {
    this.#store(LINES_KEY, text);
  }

  /** If the device is full, the work lasts until the teacher leaves the page. */
  #store(key: string, text: string): void {
    try {
      if (text === "") this.#device.removeItem(key);
      else this.#device.setItem(key, text);
    } catch {
      this.#device.removeItem(key);
    }
  }
}
