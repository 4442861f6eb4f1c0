/**
 * What the device remembers of the lessons: missions that are done, which work holds the attempt at
 * which mission, and where the reader came from. Shared challenges are kept by the work that they are
 * tried in. Without a schema, so that the first screen can ask it.
 */
import { challengeKey, type KeyValueStorage } from "../../app/project-storage.ts";

/** What a mission took when it was done, at its best: the fewest lines, then the shortest time. */
export interface Done {
  lines: number;
  ticks: number;
}

export interface LessonsRecord {
  /** by id of the mission; ids of a later Corridor are kept as they are */
  done: Readonly<Record<string, Done>>;
  /** id of the work that holds the attempt, by id of the mission */
  works: Readonly<Record<string, string>>;
  /** the best result of each open project: numbers of which fewer are better, the first counts most */
  best: Readonly<Record<string, readonly number[]>>;
  /** id of the work that was open before the first mission; null when it is not known */
  home: string | null;
}

const KEY = "corridor.lessons";
const nothing: LessonsRecord = { done: {}, works: {}, best: {}, home: null };

export class LessonsStorage {
  readonly #device: KeyValueStorage;
  /** what the page knows where the device did not take it; null where the device has it all */
  #unkept: LessonsRecord | null = null;
  #read: { text: string | null; record: LessonsRecord } = { text: null, record: nothing };
  readonly #challenges = new Map<string, string>();

  constructor(device: KeyValueStorage) {
    this.#device = device;
  }

  /** Whether this device has seen the lessons, or was asked and said no. */
  get isKnown(): boolean {
    return this.#device.getItem(KEY) !== null;
  }

  /** As it stands now, with what other tabs have added; the same object as long as it is the same. */
  get record(): LessonsRecord {
    if (this.#unkept !== null) return this.#unkept;
    const text = this.#device.getItem(KEY);
    if (text !== this.#read.text) this.#read = { text, record: parse(text) };
    return this.#read.record;
  }

  /** Adds entries; of a mission that was done before, the better one stays. @returns whether the device keeps it */
  add({ done = {}, works = {}, best = {}, home }: Partial<LessonsRecord>): boolean {
    const record = this.#newest();
    return this.#write({
      done: bestOf(record.done, done),
      works: { ...record.works, ...works },
      best: fewestOf(record.best, best),
      home: home === undefined ? record.home : home,
    });
  }

  /** Forgets what is done, in every tab; attempts stay. @returns whether the device keeps it */
  forgetDone(): boolean {
    return this.#write({ ...this.#newest(), done: {}, best: {} });
  }

  /** A work is no attempt at a mission any more. @returns whether the device keeps it */
  dropWork(work: string): boolean {
    const record = this.#newest();
    const left = Object.entries(record.works).filter(([, id]) => id !== work);
    return this.#write({ ...record, works: Object.fromEntries(left) });
  }

  /** What another tab has stored since, where this one could not store its own. */
  #newest(): LessonsRecord {
    const unkept = this.#unkept;
    if (unkept === null) return this.record;
    const stored = parse(this.#device.getItem(KEY));
    return {
      done: bestOf(stored.done, unkept.done),
      works: { ...stored.works, ...unkept.works },
      best: fewestOf(stored.best, unkept.best),
      home: unkept.home,
    };
  }

  #write(record: LessonsRecord): boolean {
    const isKept = this.#keep(KEY, JSON.stringify(record));
    this.#unkept = isKept ? null : record;
    return isKept;
  }

  /** The mission whose attempt this work is; null when it is none. */
  missionOf(work: string): string | null {
    return Object.entries(this.record.works).find(([, id]) => id === work)?.[0] ?? null;
  }

  /** The text of the shared challenge that is tried in this work; null when there is none. */
  challengeOf(work: string): string | null {
    return this.#challenges.get(work) ?? this.#device.getItem(challengeKey(work));
  }

  /** @returns whether the device keeps it */
  keepChallenge(work: string, text: string): boolean {
    this.#challenges.set(work, text);
    return this.#keep(challengeKey(work), text);
  }

  dropChallenge(work: string): void {
    this.#challenges.delete(work);
    this.#device.removeItem(challengeKey(work));
  }

  #keep(key: string, text: string): boolean {
    try {
      this.#device.setItem(key, text);
      return true;
    } catch {
      return false;
    }
  }
}

/** All missions of both; where both have one, the fewer lines, then the shorter time. */
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

/** All results of both; where both have one, the one whose first different number is smaller. */
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

/** What cannot be read counts as nothing: the works themselves are kept elsewhere. */
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
