/**
 * Saves every edit of a lesson on the device: soon after the edit, and at once when the page is left.
 * If another tab saved the lesson in the meantime, this tab continues with a copy, so that both
 * versions remain.
 */
import { createStore, type StoreApi } from "zustand/vanilla";
import type { LessonDraft } from "./lesson-draft.ts";
import { newTextId } from "../../../model/storage/new-text-id.ts";
import { withoutBlankTexts } from "../../../model/teaching/blank-texts.ts";
import type { SavedLesson, SavedLessons } from "../../../model/teaching/saved-lessons.ts";

/** The first of several quick edits starts the timer. */
const SAVE_AFTER_MS = 250;

export interface SaveState {
  /** of the entry that this tab writes; another one after a fork */
  id: string;
  status: "saved" | "saving" | "blocked";
  /** whether another tab had changed the lesson, so that this one is a copy */
  isFork: boolean;
}

interface AutosavePorts {
  lessons: Pick<SavedLessons, "canOverwrite" | "write">;
  draft: LessonDraft;
  now: () => number;
  /** calls a function later, such as `setTimeout` */
  later: (run: () => void, milliseconds: number) => void;
}

export class LessonAutosave {
  readonly store: StoreApi<SaveState>;
  readonly #ports: AutosavePorts;
  #saved: SavedLesson;
  #isScheduled = false;
  #stop: () => void = () => undefined;

  /** @param saved the entry of the draft, as this tab read or wrote it last */
  constructor(ports: AutosavePorts, saved: SavedLesson) {
    this.#ports = ports;
    this.#saved = saved;
    this.store = createStore<SaveState>()(() => ({ id: saved.id, status: "saved", isFork: false }));
  }

  /** Starts to observe the draft. */
  start(): void {
    this.#stop = this.#ports.draft.store.subscribe(() => this.#schedule());
  }

  /** Saves pending edits now. */
  flush(): void {
    if (this.#isSaved()) {
      this.store.setState({ status: "saved" });
      return;
    }
    const { lessons, draft, now } = this.#ports;
    const { lesson, solutions } = draft.store.getState();
    const isFork = !lessons.canOverwrite(this.#saved);
    const next: SavedLesson = {
      id: isFork ? newTextId() : this.#saved.id,
      savedAt: now(),
      revision: newTextId(),
      lesson,
      solutions,
    };
    try {
      lessons.write({ ...next, lesson: withoutBlankTexts(lesson) });
    } catch {
      this.store.setState({ status: "blocked" });
      return;
    }
    this.#saved = next;
    const wasFork = this.store.getState().isFork;
    this.store.setState({ id: next.id, status: "saved", isFork: wasFork || isFork });
  }

  /** Saves pending edits, and stops. */
  end(): void {
    this.#stop();
    this.flush();
  }

  #isSaved(): boolean {
    const { lesson, solutions } = this.#ports.draft.store.getState();
    return lesson === this.#saved.lesson && solutions === this.#saved.solutions;
  }

  #schedule(): void {
    if (this.#isScheduled || this.#isSaved()) return;
    this.#isScheduled = true;
    // A refusal stays visible until a write succeeds.
    if (this.store.getState().status === "saved") this.store.setState({ status: "saving" });
    this.#ports.later(() => {
      this.#isScheduled = false;
      this.flush();
    }, SAVE_AFTER_MS);
  }
}
