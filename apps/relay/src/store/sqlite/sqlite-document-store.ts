/** Documents behind short links in the relay's SQLite file. */
import { isDiskFull } from "../../platform/errors/disk-full.ts";
import type { DocumentStore, NewDocument, RemoveResult } from "../document-store.ts";
import { SqliteFile } from "./file/sqlite-file.ts";
import type { Statements } from "./file/statements.ts";

export class SqliteDocumentStore implements DocumentStore {
  readonly #file: SqliteFile;

  /** @param file a file or its path; closing the store closes the file */
  constructor(file: SqliteFile | string) {
    this.#file = typeof file === "string" ? new SqliteFile(file) : file;
  }

  async add({ ids, hash, text, keyHash, now }: NewDocument): Promise<string> {
    const { writing } = this.#file;
    return this.#file.growingStep(() => {
      const known = found(writing, "SELECT id AS found FROM documents WHERE hash = ?", hash);
      const isFree = (id: string): boolean =>
        found(writing, "SELECT id AS found FROM documents WHERE id = ?", id) === null;
      const stored = known ?? ids.find(isFree);
      if (stored === undefined) throw new Error("all candidate ids are in use");
      writing.run(
        `INSERT INTO documents (id, hash, text, last_used_at) VALUES (?, ?, ?, ?)
         ON CONFLICT (hash) DO UPDATE SET last_used_at = max(last_used_at, excluded.last_used_at)`,
        [stored, hash, text, now],
      );
      writing.run("INSERT INTO document_keys (document, hash) VALUES (?, ?)", [stored, keyHash]);
      return stored;
    });
  }

  async read(id: string, now: number, noteMs: number): Promise<string | null> {
    const sql = "SELECT text AS found FROM documents WHERE id = ?";
    const text = found(this.#file.reading, sql, id);
    if (text === null) return null;
    await this.#noteUse(id, now, noteMs);
    return text;
  }

  async remove(id: string, keyHash: string): Promise<RemoveResult> {
    const { writing } = this.#file;
    const work = (): RemoveResult => {
      if (found(writing, "SELECT id AS found FROM documents WHERE id = ?", id) === null) {
        return "no-document";
      }
      const key = "DELETE FROM document_keys WHERE document = ? AND hash = ?";
      if (writing.run(key, [id, keyHash]) === 0) return "wrong-key";
      writing.run(
        `DELETE FROM documents WHERE id = ?1
         AND NOT EXISTS (SELECT 1 FROM document_keys WHERE document = ?1)`,
        [id],
      );
      return "removed";
    };
    return this.#file.remove(work, (result) => result === "removed");
  }

  async removeUnused(before: number): Promise<number> {
    const sql = "DELETE FROM documents WHERE last_used_at < ?";
    return this.#file.remove(
      () => this.#file.writing.run(sql, [before]),
      (count) => count > 0,
    );
  }

  async close(): Promise<void> {
    await this.#file.close();
  }

  async #noteUse(id: string, now: number, noteMs: number): Promise<void> {
    const isDue = "SELECT id AS found FROM documents WHERE id = ? AND last_used_at < ? - ?";
    if (this.#file.reading.all(isDue, [id, now, noteMs]).length === 0) return;
    const sql = "UPDATE documents SET last_used_at = ?1 WHERE id = ?2 AND last_used_at < ?1 - ?3";
    try {
      await this.#file.growingStep(() => this.#file.writing.run(sql, [now, id, noteMs]));
    } catch (error) {
      // Reading must work on a full disk. The next read records its use instead.
      if (!isDiskFull(error)) throw error;
    }
  }
}

function found(statements: Statements, sql: string, value: string): string | null {
  const [row] = statements.all(sql, [value]);
  return typeof row?.["found"] === "string" ? row["found"] : null;
}
