/**
 * The classes that a teacher runs from this device: the key, and what the service never receives,
 * such as notes about students.
 * An entry lasts until the class ends, so a closed tab loses no lesson.
 */
import { keysUnder, type KeyValueStorage } from "../storage/key-value-storage.ts";

export interface OwnClass {
  id: string;
  /** of a teacher */
  key: string;
  /** of a big screen; null: a device that joined by the teacher's link does not have it */
  screenKey: string | null;
  /** what the teacher calls the class, such as 8B; may be empty */
  label: string;
  /** ms since 1970 */
  startedAt: number;
  /** what the teacher notes about students, such as who Juniper is, by their numbers */
  notes: Readonly<Record<string, string>>;
}

const PREFIX = "corridor.classroom.";
/** The longest life of a class, in ms. */
const LIFE_MS = 12 * 3_600_000;
export const MAX_CLASS_LABEL = 40;
export const MAX_NOTE = 80;

export class OwnClasses {
  readonly #device: KeyValueStorage;
  readonly #now: () => number;

  /** @param now ms since 1970 */
  constructor(device: KeyValueStorage, now: () => number) {
    this.#device = device;
    this.#now = now;
  }

  /** The newest first. Removes the entries of classes that must have ended. */
  list(): OwnClass[] {
    return keysUnder(this.#device, PREFIX)
      .map((key) => key.slice(PREFIX.length))
      .flatMap((id) => this.read(id) ?? [])
      .filter(({ id, startedAt }) => {
        const isOver = this.#now() - startedAt > LIFE_MS;
        if (isOver) this.remove(id);
        return !isOver;
      })
      .toSorted((a, b) => b.startedAt - a.startedAt);
  }

  /** null: not from this device */
  read(id: string): OwnClass | null {
    const text = this.#device.getItem(PREFIX + id);
    if (text === null) return null;
    try {
      const entry = JSON.parse(text) as Partial<Record<keyof OwnClass, unknown>>;
      if (typeof entry.key !== "string") return null;
      return {
        id,
        key: entry.key,
        screenKey: typeof entry.screenKey === "string" ? entry.screenKey : null,
        label: typeof entry.label === "string" ? entry.label.slice(0, MAX_CLASS_LABEL) : "",
        startedAt: typeof entry.startedAt === "number" ? entry.startedAt : this.#now(),
        notes: notesOf(entry.notes),
      };
    } catch {
      return null;
    }
  }

  /** Without storage, a closed tab needs the link of the dashboard again. */
  store({ id, ...entry }: OwnClass): void {
    try {
      this.#device.setItem(PREFIX + id, JSON.stringify(entry));
    } catch {
      // Full or forbidden: the tab still has the key.
    }
  }

  /** Changes an entry. Nothing happens after the end of the class. */
  change(id: string, change: Partial<Pick<OwnClass, "key" | "label" | "notes">>): void {
    const stored = this.read(id);
    if (stored !== null) this.store({ ...stored, ...change });
  }

  /** Stores a note about a student. @param text empty: none */
  setNote(id: string, student: number, text: string): void {
    const { [String(student)]: _before, ...others } = this.read(id)?.notes ?? {};
    const notes = text === "" ? others : { ...others, [student]: text.slice(0, MAX_NOTE) };
    this.change(id, { notes });
  }

  remove(id: string): void {
    this.#device.removeItem(PREFIX + id);
  }
}

function notesOf(value: unknown): OwnClass["notes"] {
  if (typeof value !== "object" || value === null) return {};
  const notes = Object.entries(value).flatMap(([student, text]: [string, unknown]) =>
    typeof text === "string" ? [[student, text.slice(0, MAX_NOTE)]] : [],
  );
  return Object.fromEntries(notes) as OwnClass["notes"];
}
