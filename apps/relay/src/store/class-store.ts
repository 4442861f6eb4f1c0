/**
 * Storage of classes: the lesson, names, hashed keys, progress and newest programs, until the class
 * ends.
 *
 * A class is one record with a version. `commit` replaces rows of the class if nothing has
 * changed it since, so that several relays can share a store. A store knows no rules of a class.
 * Every implementation passes `cases/class-store.cases.ts`.
 */
export type ClassKeyKind = "teach" | "show";

/** The class without its students. */
export interface ClassRow {
  /** increases with each commit */
  version: number;
  /** number of the newest event */
  n: number;
  /** name of the event stream */
  stream: string;
  createdAt: number;
  /** pseudonyms; null: words */
  names: readonly string[] | null;
  expected: number | null;
  keys: readonly { kind: ClassKeyKind; hash: string }[];
  code: string;
  isLocked: boolean;
  /** the newest pause, which may have ended */
  pause: { startedAt: number; endsAt: number } | null;
  /** sum of the pauses before the newest one, in ms */
  pausedMs: number;
  /** the tasks up to this number are open; null: all */
  paceTo: number | null;
  lessonVersion: string;
  /** number of the student who joined last */
  lastStudent: number;
}

export interface StudentRow {
  student: number;
  /** index of the name in `names`, or of the word */
  name: number;
  renamesLeft: number;
  /** SHA-256 of the key */
  key: string;
  joinedAt: number;
  helpSince: number | null;
  /** seq of the newest progress record */
  progress: number;
  /** number of stored programs */
  programs: number;
  /** SHA-256 of the newest code by which another device becomes the student; null: none */
  returnCode: { hash: string; endsAt: number } | null;
}

export interface LoadedClass {
  row: ClassRow;
  students: StudentRow[];
}

/** A code that admits to a class, by its hash. */
export interface CodeRow {
  /** SHA-256 of the code */
  hash: string;
  /** the student who returns with it; null: it admits new students */
  student: number | null;
  /** null: until it is deleted */
  endsAt: number | null;
}

/** What a commit stores and deletes. */
export interface ClassChanges {
  row: ClassRow;
  /** new and changed students */
  students: readonly StudentRow[];
  /** students to delete, with their codes, records and programs */
  removed: readonly number[];
  /** new progress records, as JSON */
  progress: readonly { student: number; seq: number; text: string }[];
  /** newest programs, as JSON */
  programs: readonly { student: number; text: string }[];
  /** a new lesson, as JSON; null: unchanged */
  lesson: string | null;
  newCodes: readonly CodeRow[];
  /** hashes of codes to delete */
  oldCodes: readonly string[];
}

export interface NewClass {
  id: string;
  row: ClassRow;
  lesson: string;
  code: string;
}

/** conflict: another relay has changed the class; code-taken: another class has the code */
export type ClassCommitResult = "committed" | "conflict" | "code-taken" | "no-class";

/** The class that a code admits to, and the student who returns with it. */
export interface FoundCode extends Pick<CodeRow, "student" | "endsAt"> {
  id: string;
}

export interface ClassStore {
  /** @returns false if another class has the code */
  create(created: NewClass): Promise<boolean>;
  load(id: string): Promise<LoadedClass | null>;
  /**
   * Stores the changes if the stored class still has this version.
   * @param message for other relays, which a store that publishes sends with the commit
   */
  commit(
    id: string,
    version: number,
    changes: ClassChanges,
    message: string,
  ): Promise<ClassCommitResult>;
  /**
   * Waits until the files contain nothing of the students that were removed. Not a part of `commit`,
   * because a large store takes seconds, and the next commit of the class must not wait.
   */
  erased(): Promise<void>;
  /** Finds a code, which may have expired. @param hash of the code */
  findCode(hash: string): Promise<FoundCode | null>;
  lesson(id: string): Promise<string | null>;
  /** The newest program of a student, as JSON. */
  program(id: string, student: number): Promise<string | null>;
  /** All progress records as JSON, by student and in order. */
  progress(id: string): Promise<{ student: number; text: string }[]>;
  /** Records a use of the class. Times never decrease. */
  touch(id: string, now: number): Promise<void>;
  /** Deletes the class and all of its data. @returns false if there was none */
  remove(id: string): Promise<boolean>;
  /** Deletes classes last used or created before these times. @returns their ids */
  removeExpired(before: { lastUsedAt: number; createdAt: number }): Promise<string[]>;
}
