/** The teacher's work on hand-ins: the open lesson, its chosen tasks, files and lines. */
import { countMazes, type LessonDocument } from "@corridor/challenge";
import { createStore, type StoreApi } from "zustand/vanilla";
import type { TextFile } from "../../ui/incoming-files.ts";
import type { HandInCheck } from "./check-hand-ins.ts";
import {
  attemptText,
  countHandIns,
  entriesOf,
  MAX_HAND_INS,
  readHandInFiles,
  type ChosenTask,
  type HandInFile,
} from "./hand-in-entries.ts";
import {
  looksLikeLesson,
  readLessonFile,
  type LessonProblem,
  type OpenedLesson,
} from "./lessons/read-lesson.ts";
import type { TeachStorage } from "./teach-storage.ts";

/** Maximum number of runs in one check: a run is one hand-in in one maze. */
const MAX_RUNS = 500_000;
/** More than the longest text of a lesson, which has 2 MiB. */
const MAX_LESSON_BYTES = 8_000_000;

/** Why a check does not start. */
export type CheckRefusal =
  | { code: "no-hand-in" }
  | { code: "no-task" }
  | { code: "too-many"; found: number; most: number }
  | { code: "too-many-runs"; found: number; most: number };

export interface HandInsState {
  lesson: LessonDocument | null;
  /** why the last lesson was not opened */
  problem: LessonProblem | null;
  isOpening: boolean;
  /** whether each task of the lesson is checked */
  chosen: readonly boolean[];
  files: readonly HandInFile[];
  /** links and codes, one a line */
  text: string;
  refusal: CheckRefusal | null;
}

interface WorkPorts {
  storage: TeachStorage;
  check: Pick<HandInCheck, "start" | "clear">;
  /** reads a link, a short link or a document */
  readAddress: (text: string) => Promise<OpenedLesson>;
}

export class HandInsWork {
  readonly store: StoreApi<HandInsState>;
  readonly #ports: WorkPorts;

  constructor(ports: WorkPorts) {
    this.#ports = ports;
    const lesson = ports.storage.readLesson();
    this.store = createStore<HandInsState>()(() => ({
      lesson,
      problem: null,
      isOpening: false,
      chosen: allChosen(lesson),
      files: [],
      text: ports.storage.readLines(),
      refusal: null,
    }));
  }

  /** Opens the lesson of a link, a short link or a document. */
  async openAddress(text: string): Promise<void> {
    this.store.setState({ isOpening: true, problem: null });
    this.#open(await this.#ports.readAddress(text));
  }

  openLesson(lesson: LessonDocument): void {
    this.#open({ ok: true, lesson });
  }

  async openFile(file: TextFile): Promise<void> {
    this.#open(await readLessonFile(file));
  }

  /** Closes the lesson, so that another one can be opened; hand-ins stay. */
  close(): void {
    this.#ports.check.clear();
    this.store.setState({ lesson: null, problem: null, chosen: [], refusal: null });
  }

  /** Adds dropped, pasted or chosen files. A lesson among them opens. */
  async addFiles(files: readonly TextFile[]): Promise<void> {
    const lessons = await Promise.all(files.map(isLesson));
    const lesson = files.find((_, at) => lessons[at]);
    if (lesson !== undefined) await this.openFile(lesson);
    const others = files.filter((_, at) => lessons[at] !== true);
    const free = MAX_HAND_INS - this.store.getState().files.length;
    if (others.length > free) {
      const found = this.store.getState().files.length + others.length;
      this.store.setState({ refusal: { code: "too-many", found, most: MAX_HAND_INS } });
      return;
    }
    const read = await readHandInFiles(others);
    this.store.setState(({ files: before }) => ({
      files: [...before.filter((file) => !read.some((each) => isSameFile(file, each))), ...read],
      refusal: null,
    }));
  }

  removeFiles(): void {
    this.store.setState({ files: [], refusal: null });
  }

  setText(text: string): void {
    this.#ports.storage.storeLines(text);
    this.store.setState({ text, refusal: null });
  }

  /** Adds pasted lines at the end. */
  addLines(lines: string): void {
    const { text } = this.store.getState();
    this.setText(text === "" || text.endsWith("\n") ? text + lines : `${text}\n${lines}`);
  }

  chooseTask(at: number, isChosen: boolean): void {
    const { chosen } = this.store.getState();
    this.store.setState({ chosen: chosen.with(at, isChosen), refusal: null });
  }

  /** Checks all hand-ins in the chosen tasks, or states why not. */
  startCheck(): void {
    const { lesson, chosen, files, text } = this.store.getState();
    const tasks = (lesson?.tasks ?? [])
      .map((task, at): ChosenTask => ({ task, number: at + 1 }))
      .filter((_, at) => chosen[at]);
    const refusal = refusalOf(tasks, countHandIns(files, text));
    this.store.setState({ refusal });
    if (refusal !== null || lesson === null) return;
    this.#ports.check.start(tasks, entriesOf(files, text, lesson));
  }

  #open(opened: OpenedLesson): void {
    if (!opened.ok) {
      const { code, problems } = opened;
      this.store.setState({ isOpening: false, problem: { code, problems } });
      return;
    }
    const { lesson } = opened;
    this.#ports.check.clear();
    this.#ports.storage.storeLesson(lesson);
    const chosen = allChosen(lesson);
    this.store.setState({ lesson, chosen, isOpening: false, problem: null, refusal: null });
  }
}

function allChosen(lesson: LessonDocument | null): boolean[] {
  return lesson?.tasks.map(() => true) ?? [];
}

function refusalOf(tasks: readonly ChosenTask[], handIns: number): CheckRefusal | null {
  if (handIns === 0) return { code: "no-hand-in" };
  if (tasks.length === 0) return { code: "no-task" };
  if (handIns > MAX_HAND_INS) return { code: "too-many", found: handIns, most: MAX_HAND_INS };
  const found = handIns * tasks.reduce((sum, { task }) => sum + countMazes(task), 0);
  return found > MAX_RUNS ? { code: "too-many-runs", found, most: MAX_RUNS } : null;
}

async function isLesson(file: TextFile): Promise<boolean> {
  if (file.size > MAX_LESSON_BYTES) return false;
  try {
    return looksLikeLesson(await file.text());
  } catch {
    return false;
  }
}

/**
 * Whether a file is there again: with the same attempt, or readable now. The files of several
 * students often have one name, that of the program with which a task begins.
 */
function isSameFile(before: HandInFile, again: HandInFile): boolean {
  if (before.name !== again.name) return false;
  if (!before.read.ok || !again.read.ok) return !before.read.ok;
  return attemptText(before.read.value.attempt) === attemptText(again.read.value.attempt);
}
