/** The newest programs of the students, read again after each edit. */
import { decodeLink } from "@corridor/link";
import type { ProgramDocument } from "@corridor/program";
import type { SeenStudent } from "../../simulator/protocol/classroom-messages.ts";
import type { ClassCalls } from "./class-calls.ts";

/** A student edits every few seconds; the number of lines may be a little late. */
const INTERVAL_MS = 4_000;

export interface ReadProgram {
  task: number;
  /** null: a drive */
  program: ProgramDocument | null;
  /** the text from which it was read */
  link: string;
}

export type Programs = ReadonlyMap<number, ReadProgram>;

export class ProgramReader {
  readonly #calls: Pick<ClassCalls, "program">;
  readonly #later: (run: () => void, ms: number) => void;
  readonly #changed: (programs: Programs) => void;
  readonly #programs = new Map<number, ReadProgram>();
  /** number of stored programs when a student's program was last read */
  readonly #read = new Map<number, number>();
  #students: ReadonlyMap<number, Pick<SeenStudent, "programs">> = new Map();
  #isReading = false;

  constructor(
    calls: Pick<ClassCalls, "program">,
    later: (run: () => void, ms: number) => void,
    changed: (programs: Programs) => void,
  ) {
    this.#calls = calls;
    this.#later = later;
    this.#changed = changed;
  }

  follow(students: ReadonlyMap<number, Pick<SeenStudent, "programs">>): void {
    this.#students = students;
    if (this.#isReading) return;
    this.#isReading = true;
    void this.#readAll();
  }

  async #readAll(): Promise<void> {
    let isRead = false;
    for (const [student, { programs }] of this.#students) {
      if (programs === 0 || this.#read.get(student) === programs) continue;
      this.#read.set(student, programs);
      isRead = true;
      const stored = await this.#calls.program(student);
      // Without a network, it is read again.
      if (stored === null) this.#read.delete(student);
      const decoded = stored === null ? null : decodeLink(stored.link);
      if (stored === null || decoded?.ok !== true) continue;
      const { program, run } = decoded.value;
      const { task, link } = stored;
      this.#programs.set(student, { task, program: program ?? run?.program ?? null, link });
    }
    if (!isRead) {
      this.#isReading = false;
      return;
    }
    this.#changed(new Map(this.#programs));
    this.#later(() => void this.#readAll(), INTERVAL_MS);
  }
}
