/**
 * Short links as the page makes and deletes them. The keys that delete them stay on the device, so that
 * whoever made a link can delete it later too; where the device keeps nothing, until the page is left.
 */
import type { ChallengeDocument } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";
import {
  storedLinksSchema,
  MAX_STORED_LINKS,
  readJson,
  shortLinkSchema,
  type ShortLink,
} from "@corridor/protocol";
import type { KeyValueStorage } from "../../app/project-storage.ts";

const KEPT = "corridor.shortLinks";
const MAX_KEPT_TEXT = 100_000;
const MAX_ANSWER = 4_096;

/** fetch, as far as it is needed */
export type Ask = (url: string, init?: RequestInit) => Promise<Response>;

export class ShortLinkService {
  readonly #ask: Ask;
  readonly #device: KeyValueStorage;
  #made: ShortLink[];

  constructor(ask: Ask, device: KeyValueStorage) {
    this.#ask = ask;
    this.#device = device;
    const kept = readJson(storedLinksSchema, device.getItem(KEPT) ?? "[]", MAX_KEPT_TEXT);
    this.#made = kept.ok ? kept.value : [];
  }

  /** Whether there is a service behind this page, or files alone. */
  async answers(): Promise<boolean> {
    try {
      const answer = await this.#ask("/healthz", { cache: "no-store" });
      const type = answer.headers.get("content-type") ?? "";
      return answer.ok && type.startsWith("application/json");
    } catch {
      return false;
    }
  }

  /** @returns the address, or null when there is none to be had now */
  async make(document: MazeDocument | ChallengeDocument): Promise<ShortLink | null> {
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

  /** Takes back all that this device has stored under a link. @returns whether the service did it */
  async delete(id: string): Promise<boolean> {
    try {
      for (const link of this.#made.filter((each) => each.id === id)) {
        const answer = await this.#ask(`/api/v1/mazes/${id}`, {
          method: "DELETE",
          headers: { Authorization: `Bearer ${link.deleteKey}` },
        });
        // Gone already, or no longer this device's: nothing is left to delete.
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
      this.#device.setItem(KEPT, JSON.stringify(this.#made));
    } catch {
      // A full device: the keys last as long as the page.
    }
  }
}
