/**
 * What the device stores for the lessons: finished missions, the project of each attempt, and the
 * project from before. A shared challenge is stored under the id of its project. The first screen
 * imports this module, so it uses no schema.
 */
import { challengeKey } from "../projects/project-storage.ts";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";

/** The best result of a finished mission: fewest lines, then shortest time. */
export interface Done {
  lines: number;
  ticks: number;
}

export interface LessonsRecord {
  /** by mission id; ids from a later version of Corridor are retained */
  done: Readonly<Record<string, Done>>;
  /** id of the project with the attempt, by mission id; the stored documents name it so */
  works: Readonly<Record<string, string>>;
  /** best result of each bonus mission: smaller numbers are better, and the first counts most */
  best: Readonly<Record<string, readonly number[]>>;
  /** id of the project that was open before the first mission; null if unknown */
  home: string | null;
}

const KEY = "corridor.lessons";
const nothing: LessonsRecord = { done: {}, works: {}, best: {}, home: null };

export class LessonsStorage {
  readonly #device: KeyValueStorage;
  /** the record, if the device failed to store it; null if the device stores everything */
  #pending: LessonsRecord | null = null;
  #read: { text: string | null; record: LessonsRecord } = { text: null, record: nothing };
  readonly #challenges = new Map<string, string>();

  constructor(device: KeyValueStorage) {
    this.#device = device;
  }

  /** Whether this device has opened the lessons or dismissed the invitation. */
  get isKnown(): boolean {
    return this.#device.getItem(KEY) !== null;
  }

  /**
   * The current record, including changes from other tabs. Returns the same object until it
   * changes.
   */
  get record(): LessonsRecord {
    if (this.#pending !== null) return this.#pending;
    const text = this.#device.getItem(KEY);
    if (text !== this.#read.text) this.#read = { text, record: parse(text) };
    return this.#read.record;
  }

  /**
   * Adds entries. For a mission that is already finished, the better result stays.
   * @returns whether the device stored the record
   */
  add({ done = {}, works = {}, best = {}, home }: Partial<LessonsRecord>): boolean {
    const record = this.#newest();
    return this.#write({
      done: bestOf(record.done, done),
      works: { ...record.works, ...works },
      best: fewestOf(record.best, best),
      home: home === undefined ? record.home : home,
    });
  }

  /**
   * Deletes the progress in every tab. Attempts stay.
   * @returns whether the device stored the record
   */
  deleteProgress(): boolean {
    return this.#write({ ...this.#newest(), done: {}, best: {} });
  }

  /**
   * Removes a project from the attempts.
   * @returns whether the device stored the record
   */
  removeAttempt(project: string): boolean {
    const record = this.#newest();
    const left = Object.entries(record.works).filter(([, id]) => id !== project);
    return this.#write({ ...record, works: Object.fromEntries(left) });
  }

  /** Merges what other tabs stored with what this tab could not store. */
  #newest(): LessonsRecord {
    const pending = this.#pending;
    if (pending === null) return this.record;
    const stored = parse(this.#device.getItem(KEY));
    return {
      done: bestOf(stored.done, pending.done),
      works: { ...stored.works, ...pending.works },
      best: fewestOf(stored.best, pending.best),
      home: pending.home,
    };
  }

  #write(record: LessonsRecord): boolean {
    const isStored = this.#store(KEY, JSON.stringify(record));
    this.#pending = isStored ? null : record;
    return isStored;
  }

  /** The mission whose attempt is in this project; null if there is none. */
  missionOf(project: string): string | null {
    return Object.entries(this.record.works).find(([, id]) => id === project)?.[0] ?? null;
  }

  /** The text of this project's shared challenge; null if there is none. */
  challengeOf(project: string): string | null {
    return this.#challenges.get(project) ?? this.#device.getItem(challengeKey(project));
  }

  /** Whether this project belongs to a mission or a lesson. */
  hasTask(project: string): boolean {
    return this.missionOf(project) !== null || this.challengeOf(project) !== null;
  }

  /** @returns whether the device stored the text */
  storeChallenge(project: string, text: string): boolean {
    this.#challenges.set(project, text);
    return this.#store(challengeKey(project), text);
  }

  /** Lets a copy of a project continue its task: a mission in the copy, a lesson in both. */
  copyTask(from: string, to: string): void {
    const mission = this.missionOf(from);
    if (mission !== null) this.add({ works: { [mission]: to } });
    const challenge = this.challengeOf(from);
    if (challenge !== null) this.storeChallenge(to, challenge);
  }

  deleteChallenge(project: string): void {
    this.#challenges.delete(project);
    this.#device.removeItem(challengeKey(project));
  }

  #store(key: string, text: string): boolean {
    try {
      this.#device.setItem(key, text);
      return true;
    } catch {
      return false;
    }
  }
}

/** All missions of both. For a mission in both, the one with fewer lines, then the shorter time. */
function bestOf(a: LessonsRecord["done"], b: LessonsRecord["done"]): LessonsRecord["done"] {
  const best = { ...a };
  for (const [id, done] of Object.entries(b)) {
    const before = best[id];
    const isBetter =
      before === undefined ||
      done.lines < before.lines ||
      (done.lines === before.lines && done.ticks < before.ticks);
    if (isBetter) best[id] = done;
  }
  return best;
}

/** All results of both. For a result in both, the one whose first different number is smaller. */
function fewestOf(a: LessonsRecord["best"], b: LessonsRecord["best"]): LessonsRecord["best"] {
  const best = { ...a };
  for (const [id, result] of Object.entries(b)) {
    const before = best[id];
    if (before === undefined || isFewer(result, before)) best[id] = result;
  }
  return best;
}

function isFewer(result: readonly number[], than: readonly number[]): boolean {
  const at = result.findIndex((number, index) => number !== than[index]);
  return at >= 0 && (result[at] ?? 0) < (than[at] ?? Infinity);
}

/** Unreadable text counts as an empty record. The projects themselves are stored elsewhere. */
function parse(text: string | null): LessonsRecord {
  let input: unknown;
  try {
    input = JSON.parse(text ?? "null");
  } catch {
    return nothing;
  }
  if (typeof input !== "object" || input === null) return nothing;
  const { done, works, best, home } = input as Record<string, unknown>;
  return {
    done: entriesOf(done, isDone),
    works: entriesOf(works, (value): value is string => typeof value === "string"),
    best: entriesOf(best, isNumbers),
    home: typeof home === "string" ? home : null,
  };
}

function entriesOf<Value>(
  input: unknown,
  isValue: (value: unknown) => value is Value,
): Record<string, Value> {
  if (typeof input !== "object" || input === null) return {};
  const entries: [string, unknown][] = Object.entries(input);
  return Object.fromEntries(entries.filter((entry): entry is [string, Value] => isValue(entry[1])));
}

function isNumbers(value: unknown): value is readonly number[] {
  return Array.isArray(value) && value.every((each) => typeof each === "number");
}

function isDone(value: unknown): value is Done {
  if (typeof value !== "object" || value === null) return false;
  const { lines, ticks } = value as Record<string, unknown>;
  return typeof lines === "number" && typeof ticks === "number";
}
