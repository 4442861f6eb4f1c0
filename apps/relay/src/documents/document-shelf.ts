/**
 * The documents behind short links: stored for whoever asks, shown to whoever has the link, deleted
 * by whoever has the key, forgotten when nobody has used them for long.
 */
import { readShortCode, type ShortLink } from "@corridor/protocol";
import type { Logger } from "pino";
import type { Clock } from "../clock.ts";
import { canBeKey, hashKey, mintKey, mintLinkIds } from "../keys.ts";
import { CheckQueue } from "../pairing/check-queue.ts";
import { notAuthorised, Refusal, retryAfter } from "../problems.ts";
import { limits } from "../sessions/limits.ts";
import { TokenBucket } from "../sessions/token-bucket.ts";
import type { DocumentStore } from "../store/document-store.ts";
import type { SharedDocument } from "./document-schema.ts";

const SWEEP_MS = 60 * 60 * 1000;

export class DocumentShelf {
  readonly #store: DocumentStore;
  readonly #clock: Clock;
  readonly #log: Logger;
  /** of short codes; the older ids are too long to be guessed */
  readonly #checks: CheckQueue;
  /** by address; kept in memory only */
  readonly #stored = new Map<string, TokenBucket>();
  #cancelTimer: () => void;

  constructor(store: DocumentStore, clock: Clock, log: Logger) {
    this.#store = store;
    this.#clock = clock;
    this.#log = log;
    this.#checks = new CheckQueue(clock, limits.codeChecks, null);
    this.#cancelTimer = clock.after(0, () => void this.#sweep());
  }

  /**
   * Stores a document. The same document gets the same link, and each time a key of its own.
   * @param from address of who asks, for the limit only
   * @param origin of the service as its users see it, such as https://host
   */
  async add(document: SharedDocument, from: string, origin: string): Promise<ShortLink> {
    const now = this.#clock.now();
    this.#take(from, now);
    // Read by a schema, its fields stand in one order: the same document has the same text.
    const text = JSON.stringify(document);
    const deleteKey = mintKey("delete");
    const id = await this.#store.add({
      ids: mintLinkIds(),
      hash: hashKey(text),
      text,
      keyHash: hashKey(deleteKey),
      now,
    });
    return { id, address: `${origin}/m/${id}`, deleteKey };
  }

  /**
   * The document as JSON text.
   * @param id a code in capital or small letters, or an older id
   * @param from address of who asks, for the limit of guesses only
   * @throws Refusal no-document, or too-fast when too many codes wait to be checked
   */
  async read(id: string, from: string): Promise<string> {
    const now = this.#clock.now();
    return this.#tried(id, from, (known) => this.#store.read(known, now, limits.documentNoteMs));
  }

  /** Takes back what was stored with this key. @throws Refusal no-document or not-authorised */
  async remove(id: string, key: string | null, from: string): Promise<void> {
    if (!canBeKey(key)) throw wrongKey();
    const result = await this.#tried(id, from, async (known) => {
      const removed = await this.#store.remove(known, hashKey(key));
      return removed === "no-document" ? null : removed;
    });
    if (result === "wrong-key") throw wrongKey();
  }

  async close(): Promise<void> {
    this.#cancelTimer();
    this.#checks.close();
    await this.#store.close();
  }

  /** @param look gives null where there is no document: of a short code, that is a wrong guess */
  async #tried<T>(id: string, from: string, look: (id: string) => Promise<T | null>): Promise<T> {
    const code = readShortCode(id);
    const found =
      code === null ? await look(id) : await this.#checks.run(from, async () => look(code));
    if (found === null) throw noDocument();
    return found;
  }

  #take(from: string, now: number): void {
    const bucket = this.#stored.get(from) ?? new TokenBucket(limits.documentRate, now);
    this.#stored.set(from, bucket);
    const waitMs = bucket.take(now);
    if (waitMs === 0) return;
    throw new Refusal(
      "too-fast",
      "Too many short links were made from this network. Wait a moment, then try again.",
      { headers: retryAfter(waitMs) },
    );
  }

  async #sweep(): Promise<void> {
    const now = this.#clock.now();
    for (const [from, bucket] of this.#stored) {
      if (bucket.isFull(now)) this.#stored.delete(from);
    }
    try {
      const count = await this.#store.removeUnused(now - limits.documentIdleMs);
      if (count > 0) this.#log.info({ count }, "forgot documents that nobody used");
    } catch (error) {
      this.#log.error({ err: error }, "the sweep over the documents failed");
    }
    this.#cancelTimer = this.#clock.after(SWEEP_MS, () => void this.#sweep());
  }
}

function wrongKey(): Refusal {
  return notAuthorised(
    "Send the deleteKey that came with the short link, as: Authorization: Bearer KEY",
  );
}

function noDocument(): Refusal {
  return new Refusal(
    "no-document",
    "It was deleted, or nobody used it for 180 days, or the link is cut off. Ask for it again.",
  );
}
