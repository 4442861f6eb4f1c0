/** Documents behind short links in the relay's SQLite file, by a connection of their own. */
import type { DatabaseSync, SQLInputValue } from "node:sqlite";
import { isDiskFull } from "./disk-full.ts";
import type { DocumentStore, NewDocument, RemoveResult } from "./document-store.ts";
import { openDatabase } from "./sqlite-schema.ts";
import { forgetDeleted, inTransaction } from "./sqlite-writing.ts";

export class SqliteDocumentStore implements DocumentStore {
  readonly #db: DatabaseSync;

  /** @param file path of the database, made with its folder when it is missing */
  constructor(file: string) {
    this.#db = openDatabase(file);
  }

  async add({ id, hash, text, keyHash, now }: NewDocument): Promise<string> {
    return inTransaction(this.#db, () => {
      this.#run(
        `INSERT INTO documents (id, hash, text, last_used_at) VALUES (?, ?, ?, ?)
         ON CONFLICT (hash) DO UPDATE SET last_used_at = max(last_used_at, excluded.last_used_at)`,
        [id, hash, text, now],
      );
      const stored = this.#text("SELECT id AS found FROM documents WHERE hash = ?", [hash]);
      if (stored === null) throw new Error("SQLite did not keep the document");
      this.#run("INSERT INTO document_keys (document, hash) VALUES (?, ?)", [stored, keyHash]);
      return stored;
    });
  }

  async read(id: string, now: number, noteMs: number): Promise<string | null> {
    const text = this.#text("SELECT text AS found FROM documents WHERE id = ?", [id]);
    if (text === null) return null;
    this.#noteUse(id, now, noteMs);
    return text;
  }

  async remove(id: string, keyHash: string): Promise<RemoveResult> {
    const result = inTransaction(this.#db, (): RemoveResult => {
      if (this.#text("SELECT id AS found FROM documents WHERE id = ?", [id]) === null) {
        return "no-document";
      }
      const key = "DELETE FROM document_keys WHERE document = ? AND hash = ?";
      if (this.#run(key, [id, keyHash]) === 0) return "wrong-key";
      this.#run(
        `DELETE FROM documents WHERE id = ?1
         AND NOT EXISTS (SELECT 1 FROM document_keys WHERE document = ?1)`,
        [id],
      );
      return "removed";
    });
    if (result === "removed") forgetDeleted(this.#db);
    return result;
  }

  async removeUnused(before: number): Promise<number> {
    const count = this.#run("DELETE FROM documents WHERE last_used_at < ?", [before]);
    if (count > 0) forgetDeleted(this.#db);
    return count;
  }

  async close(): Promise<void> {
    this.#db.close();
  }

  #noteUse(id: string, now: number, noteMs: number): void {
    try {
      this.#run("UPDATE documents SET last_used_at = ?1 WHERE id = ?2 AND last_used_at < ?1 - ?3", [
        now,
        id,
        noteMs,
      ]);
    } catch (error) {
      // A full disk must not keep anybody from reading; the next reader's use is noted instead.
      if (!isDiskFull(error)) throw error;
    }
  }

  #text(sql: string, values: SQLInputValue[]): string | null {
    const found = this.#db.prepare(sql).get(...values)?.["found"];
    return typeof found === "string" ? found : null;
  }

  #run(sql: string, values: SQLInputValue[]): number {
    return Number(this.#db.prepare(sql).run(...values).changes);
  }
}
