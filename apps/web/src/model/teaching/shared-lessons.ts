/**
 * The lessons that students may have: this device has shown their links, printed them, sent them to a
 * class, or opened them from a link or a file. Their completion codes contain the mark of exactly this
 * lesson, so that nothing but an edit of the teacher changes it.
 */
import { lessonMark, type LessonDocument } from "@corridor/challenge";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";

const KEY = "corridor.teach.shared";

/** Maximum number of stored marks. */
const MAX_MARKS = 300;

export class SharedLessons {
  readonly #device: KeyValueStorage;

  constructor(device: KeyValueStorage) {
    this.#device = device;
  }

  has(lesson: LessonDocument): boolean {
    return this.#marks().includes(lessonMark(lesson));
  }

  add(lesson: LessonDocument): void {
    const mark = lessonMark(lesson);
    const others = this.#marks().filter((each) => each !== mark);
    try {
      this.#device.setItem(KEY, [...others, mark].slice(-MAX_MARKS).join(" "));
    } catch {
      // A device without free storage saves no lesson either.
    }
  }

  /** The newest last. */
  #marks(): string[] {
    return this.#device.getItem(KEY)?.split(" ") ?? [];
  }
}
