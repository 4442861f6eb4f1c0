/**
 * Documents behind short links. Anyone can store a document, anyone with the link can read it, and
 * the delete key deletes it. Documents expire when unused.
 */
import { readShortCode, type ShortLink } from "@corridor/protocol";
import type { Logger } from "pino";
import type { Clock } from "../platform/time/clock.ts";
import { canBeKey, hashKey, mintKey, mintLinkIds } from "../platform/keys.ts";
import { CheckQueue } from "../platform/limits/check-queue.ts";
import { notAuthorised, Refusal, retryAfter } from "../platform/errors/problems.ts";
import { KeyedRateLimiter } from "../platform/limits/keyed-rate-limiter.ts";
import { limits } from "../platform/limits/limits.ts";
import type { DocumentStore } from "../store/document-store.ts";
import type { SharedDocument } from "./document-schema.ts";

const CLEANUP_MS = 60 * 60 * 1000;

export class DocumentService {
  readonly #store: DocumentStore;
  readonly #clock: Clock;
  readonly #log: Logger;
  /** for short codes; longer ids cannot be guessed */
  readonly #checks: CheckQueue;
  /** by client address; in memory only */
  readonly #additions: KeyedRateLimiter;
  #cancelTimer: () => void;
  #isClosed = false;

  constructor(store: DocumentStore, clock: Clock, log: Logger) {
    this.#store = store;
    this.#clock = clock;
    this.#log = log;
    this.#additions = new KeyedRateLimiter(clock, limits.documentRate);
    // No limit for all networks together: documents are public, and a wrong code elsewhere must not
    // delay a class.
    this.#checks = new CheckQueue(clock, limits.codeChecks, null);
    this.#cancelTimer = clock.after(0, () => void this.#removeUnused());
  }

  /**
   * Stores a document. Equal documents share one link, and each call returns a new delete key.
   * @param from address of the client, for the rate limit only
   * @param origin of the service as its users see it, such as https://host
   */
  async add(document: SharedDocument, from: string, origin: string): Promise<ShortLink> {
    this.#limitRate(from);
    // The schema fixes the order of fields, so equal documents serialise to equal texts.
    const text = JSON.stringify(document);
    const deleteKey = mintKey("delete");
    const id = await this.#store.add({
      ids: mintLinkIds(),
      hash: hashKey(text),
      text,
      keyHash: hashKey(deleteKey),
      now: this.#clock.now(),
    });
    return { id, address: `${origin}/m/${id}`, deleteKey };
  }

  /**
   * The document as JSON text.
   * @param id a code in any case, or 12 characters
   * @param from address of the client, for the limit of guesses only
   * @throws Refusal no-document, or too-fast if too many checks are pending
   */
  async read(id: string, from: string): Promise<string> {
    const now = this.#clock.now();
    return this.#lookUp(id, from, (known) => this.#store.read(known, now, limits.documentNoteMs));
  }

  /**
   * Deletes the document that was stored with this key. @throws Refusal no-document or
   * not-authorised
   */
  async remove(id: string, key: string | null, from: string): Promise<void> {
    if (!canBeKey(key)) throw wrongKey();
    const result = await this.#lookUp(id, from, async (known) => {
      const removed = await this.#store.remove(known, hashKey(key));
      return removed === "no-document" ? null : removed;
    });
    if (result === "wrong-key") throw wrongKey();
  }

  async close(): Promise<void> {
    this.#isClosed = true;
    this.#cancelTimer();
    this.#checks.close();
    await this.#store.close();
  }

  /**
   * @param lookUp returns null if no document exists, which counts as a wrong guess of a short code
   */
  async #lookUp<T>(
    id: string,
    from: string,
    lookUp: (id: string) => Promise<T | null>,
  ): Promise<T> {
    const code = readShortCode(id);
    const found =
      code === null
        ? await lookUp(id)
        : await this.#checks.run(from, code, async () => lookUp(code));
    if (found === null) throw noDocument();
    return found;
  }

  #limitRate(from: string): void {
    const waitMs = this.#additions.take(from);
    if (waitMs === 0) return;
    throw new Refusal(
      "too-fast",
      "This network created too many short links. Wait a moment, then try again.",
      { headers: retryAfter(waitMs) },
    );
  }

  async #removeUnused(): Promise<void> {
    try {
      const count = await this.#store.removeUnused(this.#clock.now() - limits.documentIdleMs);
      if (count > 0) this.#log.info({ count }, "deleted unused documents");
    } catch (error) {
      this.#log.error({ err: error }, "deleting unused documents failed");
    }
    if (this.#isClosed) return;
    this.#cancelTimer = this.#clock.after(CLEANUP_MS, () => void this.#removeUnused());
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
    "The document was deleted, was not used for 180 days, or the link is incomplete. Ask for a new link.",
  );
}
