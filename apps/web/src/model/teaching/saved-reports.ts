/**
 * The reports of classes that a teacher saved on this device, each under its own key. The table of a
 * report has the words by which students were known in the class, and no text that a student typed.
 */
import { keysUnder, type KeyValueStorage } from "../storage/key-value-storage.ts";

export interface SavedReport {
  /** `reportId` of the class and its lesson */
  id: string;
  /** milliseconds since 1970 */
  savedAt: number;
  /** what the teacher calls the class; may be empty */
  label: string;
  /** name of the lesson; may be empty */
  lesson: string;
  /** the letters by which students joined; may be empty */
  code: string;
  /** the table that `/teach#report` reads */
  csv: string;
}

/** A class has one report for each of its lessons. @param lesson the version of the lesson */
export function reportId(classId: string, lesson: string): string {
  return `${classId}-${lesson}`;
}

/** What the teacher calls the class, and the lesson: "8B, Two mazes". May be empty. */
export function reportName({ label, lesson }: Pick<SavedReport, "label" | "lesson">): string {
  return [label, lesson].filter((each) => each !== "").join(", ");
}

/** The fragment of the address of the reports. */
export const REPORT_HASH = "#report";

/** Maximum number of saved reports. */
export const MAX_SAVED_REPORTS = 40;

/** The address of a report. @param id null: of the list */
export function reportAddress(id: string | null = null): string {
  return `/teach${REPORT_HASH}${id === null ? "" : `=${id}`}`;
}

const PREFIX = "corridor.teach.report.";

export class SavedReports {
  readonly #device: KeyValueStorage;

  constructor(device: KeyValueStorage) {
    this.#device = device;
  }

  /** All readable reports, newest first. */
  list(): SavedReport[] {
    return this.#ids()
      .flatMap((id) => this.read(id) ?? [])
      .toSorted((a, b) => b.savedAt - a.savedAt || (a.id < b.id ? -1 : 1));
  }

  /** null if it is missing or unreadable */
  read(id: string): SavedReport | null {
    const text = this.#device.getItem(PREFIX + id);
    if (text === null) return null;
    try {
      const entry = JSON.parse(text) as Partial<Record<keyof SavedReport, unknown>>;
      const { csv, label, lesson, code, savedAt } = entry;
      if (typeof csv !== "string") return null;
      return {
        id,
        savedAt: typeof savedAt === "number" && Number.isFinite(savedAt) ? savedAt : 0,
        label: typeof label === "string" ? label : "",
        lesson: typeof lesson === "string" ? lesson : "",
        code: typeof code === "string" ? code : "",
        csv,
      };
    } catch {
      return null;
    }
  }

  /** @returns whether it is saved: the storage may be full, or turned off */
  write({ id, ...entry }: SavedReport): boolean {
    if (this.#device.getItem(PREFIX + id) === null && this.#ids().length >= MAX_SAVED_REPORTS) {
      return false;
    }
    try {
      this.#device.setItem(PREFIX + id, JSON.stringify(entry));
      return true;
    } catch {
      return false;
    }
  }

  remove(id: string): void {
    this.#device.removeItem(PREFIX + id);
  }

  #ids(): string[] {
    return keysUnder(this.#device, PREFIX).map((key) => key.slice(PREFIX.length));
  }
}
