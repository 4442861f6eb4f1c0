/**
 * The lesson of the class: it opens when the student joins, and is offered when the teacher sends
 * another one. It opens beside the student's work. The pace closes tasks, and hints of the teacher
 * appear in the task. Until another lesson opens, the one before it has all of this further on.
 */
import { lessonMark, type LessonDocument } from "@corridor/challenge";
import type { i18n } from "i18next";
import { createStore } from "zustand/vanilla";
import type { ClassHint, ClassSession } from "../../simulator/protocol/class-messages.ts";
import type { ChallengeStore } from "../challenge/challenge-store.ts";
import type { LessonsEntry } from "../lessons/lessons-entry.ts";
import { dismiss, showMessage, type Message, type ScreenStore } from "../screen/screen-store.ts";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";
import type { ClassLessonMark } from "./class-lesson-mark.ts";
import type { ClassLessonResult } from "./read-class-lesson.ts";
import { storedHints, storeHints, withHint, type Hints } from "./stored-hints.ts";
import { LESSON_KEY } from "./stored-keys.ts";

/** Time until a lesson that the teacher sent opens by itself, in ms. */
const OFFER_MS = 10_000;
/** Longest time that a lesson waits for the end of a run, after it is due, in s. */
const RUN_SECONDS = 30;
/** Time until the page asks again for a lesson that it did not receive, in ms. */
const RETRY_MS = 5_000;

export interface ClassLessonPorts {
  read: () => Promise<ClassLessonResult>;
  challenge: ChallengeStore;
  lessons: Pick<LessonsEntry, "load">;
  screen: ScreenStore;
  /** sessionStorage */
  tab: KeyValueStorage;
  words: Pick<i18n, "t">;
  lesson: ClassLessonMark;
  /** Whether the class is paused: nothing opens meanwhile. */
  isPaused: () => boolean;
  /** Whether the robot drives: a lesson that opens would end the run. */
  isDriving: () => boolean;
  /** The page knows the lesson of the class, or it is another one. */
  onLesson: () => void;
  /** The teacher has sent another lesson, which is not open yet. */
  onNext: () => void;
  /** A hint of the teacher appears in the open task. */
  onHint: (hint: number) => void;
  /** @returns a function that cancels the call */
  later: (call: () => void, ms: number) => () => void;
}

/** The lesson that this tab has opened. */
interface OpenedLesson {
  version: string;
  mark: string;
}

export function storedLesson(tab: KeyValueStorage): OpenedLesson | null {
  const [version, mark] = tab.getItem(LESSON_KEY)?.split(" ") ?? [];
  return version === undefined || mark === undefined ? null : { version, mark };
}

interface ClassLessonState {
  /** null: not received yet */
  document: LessonDocument | null;
  /** whether the student works on it, and the teacher has not sent another one */
  isOpen: boolean;
}

/** A lesson that the teacher has sent while the student works on the one before it. */
interface NextLesson {
  document: LessonDocument;
  mark: string;
  hints: Hints;
}

export class ClassLesson {
  readonly state = createStore<ClassLessonState>()(() => ({ document: null, isOpen: false }));
  readonly #ports: ClassLessonPorts;
  /** version that was requested last */
  #version: string | null = null;
  #openTo: number | undefined;
  #hints: Hints = {};
  #next: NextLesson | null = null;
  /** id of the message about a lesson that the teacher sent; null: none */
  #offer: number | null = null;
  #cancel: () => void = () => undefined;
  readonly #unsubscribe: () => void;
  #isClosed = false;

  constructor(ports: ClassLessonPorts) {
    this.#ports = ports;
    const { challenge, lesson, tab } = ports;
    const { hints, read } = storedHints(tab, lesson.mark);
    this.#hints = hints;
    challenge.setState({ hintsRead: read });
    this.#unsubscribe = challenge.subscribe((next, before) => {
      if (next.lesson !== before.lesson) this.#apply();
      if (next.hintsRead !== before.hintsRead) this.#storeHints();
    });
    this.#apply();
  }

  follow({ student }: ClassSession): void {
    if (student === null) return;
    this.#setPace(student.paceTo ?? undefined);
    if (student.lesson === this.#version) return;
    this.#version = student.lesson;
    void this.#load(student.lesson);
  }

  /** The teacher shows a hint, and all hints before it. */
  showHint({ task, hint }: ClassHint): void {
    const { challenge, lesson, screen, words, onHint } = this.#ports;
    const { t } = words;
    const index = task - 1;
    if (this.#next === null) this.#hints = withHint(this.#hints, index, hint);
    else this.#next.hints = withHint(this.#next.hints, index, hint);
    this.#apply();
    this.#storeHints();
    if (this.#next === null && lesson.openIndex(challenge.getState()) === index) {
      onHint(hint);
      showMessage(screen, { tone: "info", text: t("join:inClass.hint", { hint }) });
      return;
    }
    const text = t("join:inClass.hintOfTask", { hint, task });
    const action = {
      label: t("join:inClass.openTask", { task }),
      run: () => void this.#openTask(index),
    };
    showMessage(screen, { tone: "info", text, stays: true, action });
  }

  /** The student opens a hint, and all hints before it. */
  openHint(hint: number): void {
    const { challenge, lesson } = this.#ports;
    const index = lesson.openIndex(challenge.getState());
    if (index === null || this.#next !== null) return;
    this.#hints = withHint(this.#hints, index, hint);
    const { hintsRead = {} } = challenge.getState();
    challenge.setState({ hintsRead: withHint(hintsRead, index, hint) });
    this.#apply();
  }

  /** Opens the lesson beside the student's work. One that is already open stays as it is. */
  async open(): Promise<void> {
    const document = this.#newest();
    if (document === null || this.#isClosed) return;
    this.#endOffer();
    const { challenge, lesson, lessons, screen, words } = this.#ports;
    if (this.#next === null && lesson.openIndex(challenge.getState()) !== null) return;
    try {
      const { navigation } = await lessons.load();
      if (document !== this.#newest() || this.#isClosed) return;
      this.#replace();
      // The lesson begins with a task that is open in the class.
      challenge.setState({ openTo: this.#openTo });
      navigation.resume(document);
    } catch {
      showMessage(screen, { tone: "bad", text: words.t("lessons.notLoaded") });
      return;
    }
    this.#apply();
    this.#storeOpened();
  }

  close(): void {
    this.#isClosed = true;
    this.#endOffer();
    this.#unsubscribe();
    this.#ports.challenge.setState({ openTo: undefined, hints: undefined, hintsRead: undefined });
  }

  async #load(version: string): Promise<void> {
    const result = await this.#ports.read();
    if (version !== this.#version || this.#isClosed) return;
    if (result.ok) return this.#received(version, result.lesson);
    const { screen, words, later } = this.#ports;
    if (result.reason === "old") {
      showMessage(screen, { tone: "bad", text: words.t("join:problem.old") });
      return;
    }
    later(() => {
      if (version === this.#version && !this.#isClosed) void this.#load(version);
    }, RETRY_MS);
  }

  #received(version: string, document: LessonDocument): void {
    const { challenge, tab, lesson, isDriving, onNext } = this.#ports;
    const opened = storedLesson(tab);
    const mark = lessonMark(document);
    const isOther = lesson.mark !== mark;
    this.#next = { document, mark, hints: isOther ? {} : this.#hints };
    // The student has time to finish in the lesson before it.
    const stays = isOther && lesson.openIndex(challenge.getState()) !== null;
    if (stays) {
      lesson.isReplaced = true;
      this.#apply();
      onNext();
    } else this.#replace();
    if (opened?.version === version) return this.#endOffer();
    if (this.state.getState().isOpen) {
      this.#endOffer();
      this.#storeOpened();
    } else if (opened === null && !isDriving()) this.#openSoon(0);
    else this.#offerLesson(document);
  }

  /** The lesson that the teacher has sent last. */
  #newest(): LessonDocument | null {
    return this.#next?.document ?? this.state.getState().document;
  }

  /** The newest lesson is the lesson of the class from now on. */
  #replace(): void {
    const { challenge, lesson, onLesson } = this.#ports;
    if (this.#next === null) return;
    const { document, mark, hints } = this.#next;
    this.#next = null;
    lesson.isReplaced = false;
    this.#hints = hints;
    if (lesson.mark !== mark) challenge.setState({ hintsRead: undefined });
    lesson.set(mark);
    this.state.setState({ document });
    this.#apply();
    this.#storeHints();
    onLesson();
  }

  #storeHints(): void {
    const { challenge, lesson, tab } = this.#ports;
    const { hintsRead = {} } = challenge.getState();
    storeHints(tab, lesson.mark, { hints: this.#hints, read: hintsRead });
  }

  #storeOpened(): void {
    const { tab, lesson } = this.#ports;
    if (this.#version === null || lesson.mark === null) return;
    try {
      tab.setItem(LESSON_KEY, `${this.#version} ${lesson.mark}`);
    } catch {
      // Without storage, a reload opens the lesson again.
    }
  }

  #offerLesson({ name }: LessonDocument): void {
    const { screen, words } = this.#ports;
    const { t } = words;
    this.#endOffer();
    const text = name === "" ? t("join:inClass.sentUnnamed") : t("join:inClass.sent", { name });
    const action = { label: t("join:inClass.open"), run: () => void this.open() };
    const offer: Omit<Message, "id"> = { tone: "info", text, stays: true, action };
    this.#offer = showMessage(screen, offer);
    this.#openSoon(OFFER_MS);
  }

  /**
   * Opens the lesson after this time, but not during a pause of the class, and after the end of a
   * run.
   * @param waits how often to wait for the end of a run, for 1 s each
   */
  #openSoon(ms: number, waits = RUN_SECONDS): void {
    const { later, isPaused, isDriving } = this.#ports;
    this.#cancel();
    this.#cancel = later(() => {
      if (isPaused()) this.#openSoon(1_000, waits);
      else if (isDriving() && waits > 0) this.#openSoon(1_000, waits - 1);
      else void this.open();
    }, ms);
  }

  #endOffer(): void {
    this.#cancel();
    if (this.#offer !== null) dismiss(this.#ports.screen, this.#offer);
    this.#offer = null;
  }

  async #openTask(index: number): Promise<void> {
    await this.open();
    (await this.#ports.lessons.load()).navigation.openTask(index);
  }

  #setPace(openTo: number | undefined): void {
    const before = this.#openTo;
    if (openTo === before) return;
    this.#openTo = openTo;
    this.#apply();
    const { document, isOpen } = this.state.getState();
    if (!isOpen || document === null || before === undefined) return;
    const task = Math.min(openTo ?? document.tasks.length, document.tasks.length);
    if (task <= before) return;
    const { screen, words } = this.#ports;
    showMessage(screen, { tone: "info", text: words.t("join:inClass.paced", { task }) });
  }

  /** Applies pace and hints to the lesson of the class only. */
  #apply(): void {
    const { challenge, lesson } = this.#ports;
    const state = challenge.getState();
    const isThere = lesson.openIndex(state) !== null;
    // The student has left the lesson before it: nothing of it can be lost any more.
    if (!isThere && this.#next !== null) return this.#replace();
    const isOpen = isThere && this.#next === null;
    if (isOpen !== this.state.getState().isOpen) this.state.setState({ isOpen });
    const openTo = isThere ? this.#openTo : undefined;
    const hints = isThere ? this.#hints : undefined;
    if (openTo !== state.openTo || hints !== state.hints) challenge.setState({ openTo, hints });
  }
}
