/**
 * Storage of the documents behind short links. Each document is stored once, with the hashed keys
 * of everyone who stored it.
 *
 * Equal texts have the same id. Each person who stores a text gets a delete key. The document is
 * deleted with its last key, so that nobody deletes a document that others share.
 *
 * Both rules are in each store, because they must hold while several relays add and delete: a
 * version, as robots and classes have, would mean that each step rewrites a set of keys that has no
 * limit. Times and ids come from the caller.
 *
 * Each method is one atomic step. Every implementation passes `cases/document-store.cases.ts`.
 */
export interface NewDocument {
  /** candidate ids for a new document, at least one; the first free id is used */
  ids: readonly string[];
  /** SHA-256 of the text, to find an equal text */
  hash: string;
  text: string;
  /** SHA-256 of the key that may delete it */
  keyHash: string;
  now: number;
}

export type RemoveResult = "removed" | "no-document" | "wrong-key";

export interface DocumentStore {
  /**
   * Stores a text, or adds the key to an equal stored text.
   * @returns the id of the document
   * @throws Error if every candidate id is in use
   */
  add(document: NewDocument): Promise<string>;
  /** Reads a text. Updates the time of last use if it is older than `noteMs`. */
  read(id: string, now: number, noteMs: number): Promise<string | null>;
  /** Deletes a key. Deletes the document with its last key. */
  remove(id: string, keyHash: string): Promise<RemoveResult>;
  /** Deletes documents last used before a time. @returns how many */
  removeUnused(before: number): Promise<number>;
  close(): Promise<void>;
}
