/**
 * Creates and deletes short links. The device stores the keys, so that a student can delete a link
 * later. On a device without storage, they last until the student leaves the page.
 */
import type { ChallengeDocument, LessonDocument } from "@corridor/challenge";
import type { ProjectDocument } from "@corridor/link/project";
import type { MazeDocument } from "@corridor/maze";
import {
  storedLinksSchema,
  MAX_STORED_LINKS,
  readJson,
  shortLinkSchema,
  type ShortLink,
} from "@corridor/protocol";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";

const STORAGE_KEY = "corridor.shortLinks";
const MAX_STORED_TEXT = 100_000;
const MAX_ANSWER = 4_096;

/** What a short link can store. */
export type ShortLinkDocument = MazeDocument | ProjectDocument | ChallengeDocument | LessonDocument;

/** the part of fetch that the service uses */
export type Ask = (url: string, init?: RequestInit) => Promise<Response>;

export class ShortLinkService {
  readonly #ask: Ask;
  readonly #device: KeyValueStorage;
  #made: ShortLink[];

  constructor(ask: Ask, device: KeyValueStorage) {
    this.#ask = ask;
    this.#device = device;
    const stored = readJson(
      storedLinksSchema,
      device.getItem(STORAGE_KEY) ?? "[]",
      MAX_STORED_TEXT,
    );
    this.#made = stored.ok ? stored.value : [];
  }

  /** Whether a service responds behind this page. A static host has none. */
  async answers(): Promise<boolean> {
    try {
      const answer = await this.#ask("/healthz", { cache: "no-store" });
      const type = answer.headers.get("content-type") ?? "";
      return answer.ok && type.startsWith("application/json");
    } catch {
      return false;
    }
  }

  /** @returns the link, or null if the service does not provide one */
  async make(document: ShortLinkDocument): Promise<ShortLink | null> {
    try {
      const answer = await this.#ask("/api/v1/mazes", {
        method: "POST",
        headers: { "Content-Type": "application/json" },
        body: JSON.stringify(document),
      });
      if (answer.status !== 201) return null;
      const link = readJson(shortLinkSchema, await answer.text(), MAX_ANSWER);
      if (!link.ok) return null;
      this.#keep([...this.#made, link.value]);
      return link.value;
    } catch {
      return null;
    }
  }

  /**
   * Deletes everything that this device stored under a link.
   * @returns false if the service failed to delete it
   */
  async delete(id: string): Promise<boolean> {
    try {
      for (const link of this.#made.filter((each) => each.id === id)) {
        const answer = await this.#ask(`/api/v1/mazes/${id}`, {
          method: "DELETE",
          headers: { Authorization: `Bearer ${link.deleteKey}` },
        });
        // A deleted link (404) or an invalid key (401) leaves nothing to delete.
        if (!answer.ok && answer.status !== 404 && answer.status !== 401) return false;
        this.#keep(this.#made.filter((each) => each !== link));
      }
      return true;
    } catch {
      return false;
    }
  }

  #keep(links: ShortLink[]): void {
    this.#made = links.slice(-MAX_STORED_LINKS);
    try {
      this.#device.setItem(STORAGE_KEY, JSON.stringify(this.#made));
    } catch {
      // The device is full, so the keys last until the student leaves the page.
    }
  }
}
