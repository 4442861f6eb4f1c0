/**
 * The projects that this device stores: each a maze with its program, under its own key, so that
 * two tabs with different projects never overwrite each other.
 *
 * Stored text is parsed like any other external input, by a parser that may load after the page;
 * until then only entries written by this tab are known, and all others are left untouched. An
 * entry that cannot be parsed is moved aside, never deleted, and restored once a later Corridor can
 * parse it.
 *
 * At most 30 projects are stored, but an edited one is never deleted to make room: only unedited
 * copies are, the oldest first.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { keysUnder, type KeyValueStorage } from "../storage/key-value-storage.ts";

export interface Project {
  id: string;
  /** milliseconds since 1970 */
  savedAt: number;
  /** changes with every write, so that a tab notices writes of another one */
  revision: string;
  /** false while the project is as it was opened: such a copy can be opened again */
  edited: boolean;
  maze: MazeDocument;
  program: ProgramDocument;
}

/** An entry that was moved aside, and a displayable reason. */
export interface DamagedEntry {
  key: string;
  reason: string;
}

type ProjectResult = { ok: true; value: Project } | { ok: false; reason: string };

/** Parses stored text as the project of an id; the reason of a refusal is displayable. */
export type ReadProject = (text: string, id: string) => ProjectResult;

const MAX_PROJECTS = 30;
const PROJECT_PREFIX = "corridor.work.";
const ASIDE_PREFIX = "corridor.aside.";
const CHALLENGE_PREFIX = "corridor.challenge.";

/** Storage key of the shared challenge of a project; deleted with the project. */
export function challengeKey(project: string): string {
  return CHALLENGE_PREFIX + project;
}

export class ProjectStorage {
  readonly #storage: KeyValueStorage;
  readonly #reader: () => ReadProject | null;
  /** entries that were read or written here, by id; valid while the stored text is the same */
  readonly #cache = new Map<string, { text: string; result: ProjectResult }>();

  /** @param reader null until the parser has loaded */
  constructor(storage: KeyValueStorage, reader: () => ReadProject | null) {
    this.#storage = storage;
    this.#reader = reader;
  }

  /** Whether nothing is stored, including entries moved aside. */
  get isEmpty(): boolean {
    return (
      keysUnder(this.#storage, PROJECT_PREFIX).length === 0 &&
      keysUnder(this.#storage, ASIDE_PREFIX).length === 0
    );
  }

  /** All readable projects, newest first. */
  list(): Project[] {
    const projects: Project[] = [];
    for (const key of keysUnder(this.#storage, PROJECT_PREFIX)) {
      const result = this.#readEntry(key);
      if (result?.ok === true) projects.push(result.value);
    }
    return projects.toSorted((a, b) => b.savedAt - a.savedAt || (a.id < b.id ? -1 : 1));
  }

  /**
   * Moves unreadable entries aside, and restores entries that an older Corridor moved aside and
   * this one can parse.
   * @returns the entries that were moved aside now
   */
  sweep(): DamagedEntry[] {
    for (const key of keysUnder(this.#storage, ASIDE_PREFIX)) {
      const home = PROJECT_PREFIX + key.slice(ASIDE_PREFIX.length);
      if (this.#storage.getItem(home) !== null) continue;
      if (this.#readEntry(key)?.ok === true) this.#rename(key, home);
    }
    const damaged: DamagedEntry[] = [];
    for (const key of keysUnder(this.#storage, PROJECT_PREFIX)) {
      const result = this.#readEntry(key);
      if (result === null || result.ok) continue;
      this.#rename(key, ASIDE_PREFIX + key.slice(PROJECT_PREFIX.length));
      damaged.push({ key, reason: result.reason });
    }
    return damaged;
  }

  /** Deletes challenges without a project, left by a crashed browser or an older Corridor. */
  sweepChallenges(): void {
    for (const key of keysUnder(this.#storage, CHALLENGE_PREFIX)) {
      const id = key.slice(CHALLENGE_PREFIX.length);
      const isNeeded = this.has(id) || this.#storage.getItem(ASIDE_PREFIX + id) !== null;
      if (!isNeeded) this.#storage.removeItem(key);
    }
  }

  /** One project; null if it is missing or unreadable. */
  read(id: string): Project | null {
    const result = this.#readEntry(PROJECT_PREFIX + id);
    return result?.ok === true ? result.value : null;
  }

  /** Whether anything is stored under the id, readable or not. */
  has(id: string): boolean {
    return this.#storage.getItem(PROJECT_PREFIX + id) !== null;
  }

  /**
   * Whether writing this project overwrites only its own version: its entry has the same revision,
   * or is missing. An unreadable entry is not its own.
   */
  canOverwrite({ id, revision }: Project): boolean {
    const text = this.#storage.getItem(PROJECT_PREFIX + id);
    if (text === null) return true;
    const result = this.#readEntry(PROJECT_PREFIX + id);
    return result === null
      ? revisionIn(text) === revision
      : result.ok && result.value.revision === revision;
  }

  /**
   * Stores a project under its id, and deletes unedited copies beyond 30 projects.
   * @param challenge the result of `remove`, to restore it with the project
   * @throws the error of the storage if it is full or forbidden; nothing has changed then
   */
  write(project: Project, challenge: string | null = null): void {
    const text = JSON.stringify(project);
    if (challenge !== null) this.#storage.setItem(challengeKey(project.id), challenge);
    this.#storage.setItem(PROJECT_PREFIX + project.id, text);
    this.#cache.set(project.id, { text, result: { ok: true, value: project } });
    if (keysUnder(this.#storage, PROJECT_PREFIX).length <= MAX_PROJECTS) return;
    const projects = this.list();
    const droppable = projects.filter((each) => !each.edited && each.id !== project.id);
    const surplus = Math.min(projects.length - MAX_PROJECTS, droppable.length);
    for (let left = surplus; left > 0; left--) {
      const oldest = droppable.pop();
      if (oldest !== undefined) this.remove(oldest.id);
    }
  }

  /**
   * Deletes a project and its challenge.
   * @returns the text of the challenge; null without one
   */
  remove(id: string): string | null {
    const challenge = this.#storage.getItem(challengeKey(id));
    this.#storage.removeItem(PROJECT_PREFIX + id);
    this.#storage.removeItem(challengeKey(id));
    this.#cache.delete(id);
    return challenge;
  }

  /** null if nothing is stored, and for entries of other tabs until the parser has loaded */
  #readEntry(key: string): ProjectResult | null {
    const text = this.#storage.getItem(key);
    if (text === null) return null;
    const id = key.slice(key.lastIndexOf(".") + 1);
    const cached = this.#cache.get(id);
    if (cached?.text === text) return cached.result;
    const result = this.#reader()?.(text, id) ?? null;
    if (result !== null) this.#cache.set(id, { text, result });
    return result;
  }

  /** The copy is made first: if there is no room for it, the entry stays in place. */
  #rename(from: string, to: string): void {
    const text = this.#storage.getItem(from);
    if (text === null) return;
    try {
      this.#storage.setItem(to, text);
    } catch {
      return;
    }
    this.#storage.removeItem(from);
  }
}

/** The revision in the text of an entry, without the schema; null if the text is damaged. */
function revisionIn(text: string): string | null {
  try {
    const { revision } = JSON.parse(text) as { revision?: unknown };
    return typeof revision === "string" ? revision : null;
  } catch {
    return null;
  }
}
