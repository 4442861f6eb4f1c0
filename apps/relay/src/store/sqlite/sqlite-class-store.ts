/** Classes in the relay's SQLite file. */
import type {
  ClassChanges,
  ClassCommitResult,
  ClassStore,
  CodeRow,
  FoundCode,
  LoadedClass,
  NewClass,
} from "../class-store.ts";
import { classRowIn, studentRowIn } from "../class-rows.ts";
import { textIn, type Statements } from "./file/statements.ts";
import type { SqliteFile } from "./file/sqlite-file.ts";

export class SqliteClassStore implements ClassStore {
  readonly #file: SqliteFile;

  /** @param file closed by the caller */
  constructor(file: SqliteFile) {
    this.#file = file;
  }

  async create({ id, row, lesson, code }: NewClass): Promise<boolean> {
    const { writing } = this.#file;
    return this.#file.growingStep(() => {
      if (isCodeTaken(writing, code)) return false;
      writing.run(
        "INSERT INTO classes (id, version, row, lesson, created_at, last_used_at) VALUES (?1, ?2, ?3, ?4, ?5, ?5)",
        [id, row.version, JSON.stringify(row), lesson, row.createdAt],
      );
      insertCode(writing, id, { hash: code, student: null, endsAt: null });
      return true;
    });
  }

  async load(id: string): Promise<LoadedClass | null> {
    const { reading } = this.#file;
    const [found] = reading.all("SELECT row FROM classes WHERE id = ?", [id]);
    if (found === undefined) return null;
    const students = reading.all("SELECT row FROM students WHERE class = ? ORDER BY student", [id]);
    return {
      row: classRowIn(textIn(found, "row")),
      students: students.map((each) => studentRowIn(textIn(each, "row"))),
    };
  }

  async commit(id: string, version: number, changes: ClassChanges): Promise<ClassCommitResult> {
    const { writing } = this.#file;
    const work = (): ClassCommitResult => {
      const stored = writing.number("SELECT version AS found FROM classes WHERE id = ?", [id]);
      if (stored === null) return "no-class";
      if (stored !== version) return "conflict";
      if (changes.newCodes.some(({ hash }) => isCodeTaken(writing, hash))) return "code-taken";
      write(writing, id, changes);
      return "committed";
    };
    if (changes.removed.length === 0) return this.#file.growingStep(work);
    return this.#file.remove(work, (result) => result === "committed");
  }

  /** `commit` has erased them. */
  async erased(): Promise<void> {
    await Promise.resolve();
  }

  async findCode(hash: string): Promise<FoundCode | null> {
    const sql = "SELECT class, student, ends_at FROM class_codes WHERE hash = ?";
    const [found] = this.#file.reading.all(sql, [hash]);
    if (found === undefined) return null;
    const { student, ends_at: endsAt } = found;
    return {
      id: textIn(found, "class"),
      student: typeof student === "number" ? student : null,
      endsAt: typeof endsAt === "number" ? endsAt : null,
    };
  }

  async lesson(id: string): Promise<string | null> {
    const [found] = this.#file.reading.all("SELECT lesson FROM classes WHERE id = ?", [id]);
    return found === undefined ? null : textIn(found, "lesson");
  }

  async program(id: string, student: number): Promise<string | null> {
    const sql = `SELECT program FROM students
      WHERE class = ? AND student = ? AND program IS NOT NULL`;
    const [found] = this.#file.reading.all(sql, [id, student]);
    return found === undefined ? null : textIn(found, "program");
  }

  async progress(id: string): Promise<{ student: number; text: string }[]> {
    const sql = "SELECT student, text FROM progress WHERE class = ? ORDER BY student, seq";
    return this.#file.reading
      .all(sql, [id])
      .map((each) => ({ student: Number(each["student"]), text: textIn(each, "text") }));
  }

  async touch(id: string, now: number): Promise<void> {
    const sql = "UPDATE classes SET last_used_at = max(last_used_at, ?) WHERE id = ?";
    await this.#file.step(() => this.#file.writing.run(sql, [now, id]));
  }

  async remove(id: string): Promise<boolean> {
    return this.#file.remove(
      () => this.#file.writing.run("DELETE FROM classes WHERE id = ?", [id]) > 0,
      (isRemoved) => isRemoved,
    );
  }

  async removeExpired(before: { lastUsedAt: number; createdAt: number }): Promise<string[]> {
    const sql = "DELETE FROM classes WHERE last_used_at < ? OR created_at < ? RETURNING id";
    return this.#file.remove(
      () =>
        this.#file.writing
          .all(sql, [before.lastUsedAt, before.createdAt])
          .map((each) => textIn(each, "id")),
      (ids) => ids.length > 0,
    );
  }
}

function isCodeTaken(writing: Statements, hash: string): boolean {
  return writing.all("SELECT 1 FROM class_codes WHERE hash = ?", [hash]).length > 0;
}

function insertCode(writing: Statements, id: string, { hash, student, endsAt }: CodeRow): void {
  const sql = "INSERT INTO class_codes (hash, class, student, ends_at) VALUES (?, ?, ?, ?)";
  writing.run(sql, [hash, id, student, endsAt]);
}

function write(writing: Statements, id: string, changes: ClassChanges): void {
  const { row, students, removed, progress, programs, lesson, newCodes, oldCodes } = changes;
  writing.run(
    "UPDATE classes SET version = ?, row = ?, lesson = coalesce(?, lesson) WHERE id = ?",
    [row.version, JSON.stringify(row), lesson, id],
  );
  for (const each of students) {
    writing.run(
      `INSERT INTO students (class, student, row) VALUES (?, ?, ?)
       ON CONFLICT (class, student) DO UPDATE SET row = excluded.row`,
      [id, each.student, JSON.stringify(each)],
    );
  }
  for (const { student, seq, text } of progress) {
    const sql = "INSERT INTO progress (class, student, seq, text) VALUES (?, ?, ?, ?)";
    writing.run(sql, [id, student, seq, text]);
  }
  for (const { student, text } of programs) {
    const sql = "UPDATE students SET program = ? WHERE class = ? AND student = ?";
    writing.run(sql, [text, id, student]);
  }
  for (const hash of oldCodes) writing.run("DELETE FROM class_codes WHERE hash = ?", [hash]);
  for (const student of removed) {
    writing.run("DELETE FROM students WHERE class = ? AND student = ?", [id, student]);
    writing.run("DELETE FROM class_codes WHERE class = ? AND student = ?", [id, student]);
  }
  for (const code of newCodes) insertCode(writing, id, code);
}
