/** Recognizes the lesson of the class in what is open on the page, also after a reload. */
import { lessonMark, type LessonDocument } from "@corridor/challenge";
import type { ChallengeState } from "../challenge/challenge-store.ts";

export class ClassLessonMark {
  /** whether the teacher has sent another lesson, which is not open yet */
  isReplaced = false;
  /** null: the lesson of the class is not known yet */
  #mark: string | null;
  readonly #marks = new WeakMap<LessonDocument, string>();

  constructor(mark: string | null) {
    this.#mark = mark;
  }

  get mark(): string | null {
    return this.#mark;
  }

  /** The class has this lesson now. */
  set(mark: string): void {
    this.#mark = mark;
  }

  /** Index of the open task of the class's lesson; null if it is not open. */
  openIndex({ lesson, mission, index }: Pick<ChallengeState, "lesson" | "mission" | "index">) {
    const isOpen = lesson !== null && mission === null && this.#markOf(lesson) === this.#mark;
    return isOpen ? index : null;
  }

  #markOf(lesson: LessonDocument): string {
    const mark = this.#marks.get(lesson) ?? lessonMark(lesson);
    this.#marks.set(lesson, mark);
    return mark;
  }
}
