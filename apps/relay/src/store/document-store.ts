/**
 * What the relay keeps behind short links: documents, each once, with the keys (hashed) of those who
 * stored it.
 *
 * The same text has the same id, whoever stores it. Who stores it gets a key to take it back; the
 * document goes with the last key, so that nobody deletes what others still pass on.
 * Each method is one atomic step. Every implementation passes `testing/document-store.cases.ts`.
 */
export interface NewDocument {
  /** ids that it may get if it is not stored yet, at least one: it gets the first that is free */
  ids: readonly string[];
  /** SHA-256 of the text: by it the same text is found again */
  hash: string;
  text: string;
  /** SHA-256 of the key that may delete it */
  keyHash: string;
  now: number;
}

export type RemoveResult = "removed" | "no-document" | "wrong-key";

export interface DocumentStore {
  /**
   * Stores a text, or adds the key to what is stored already.
   * @returns the id under which it is found
   * @throws Error when none of the ids is free
   */
  add(document: NewDocument): Promise<string>;
  /** Reads a text. A use is noted when the last note is older than `noteMs`. */
  read(id: string, now: number, noteMs: number): Promise<string | null>;
  /** Takes a key away, and with the last one the document. */
  remove(id: string, keyHash: string): Promise<RemoveResult>;
  /** Deletes what was last used before a time. @returns how many documents */
  removeUnused(before: number): Promise<number>;
  close(): Promise<void>;
}
