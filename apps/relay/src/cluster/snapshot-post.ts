/**
 * Snapshots on their way to other relays: those of all robots that one relay wants, in one message every
 * 10 ms. A message for each would cost both relays more than all else that they do with it.
 */
import { isPlainSnapshot, snapshotSchema, type Snapshot } from "@corridor/protocol";
import { z } from "zod";
import type { Clock } from "../clock.ts";

const GATHER_MS = 10;

const postSchema = z.record(z.string(), snapshotSchema);

export class SnapshotPost {
  readonly #clock: Clock;
  readonly #send: (relay: string, text: string) => void;
  /** by relay, the newest of each robot */
  readonly #bags = new Map<string, Map<string, Snapshot>>();
  #cancelTimer: (() => void) | null = null;

  /** @param send takes a text to one relay, or loses it */
  constructor(clock: Clock, send: (relay: string, text: string) => void) {
    this.#clock = clock;
    this.#send = send;
  }

  post(robot: string, snapshot: Snapshot, relays: Iterable<string>): void {
    for (const relay of relays) {
      const bag = this.#bags.get(relay) ?? new Map<string, Snapshot>();
      this.#bags.set(relay, bag.set(robot, snapshot));
    }
    this.#cancelTimer ??= this.#clock.after(GATHER_MS, () => this.flush());
  }

  /** Sends what was gathered. */
  flush(): void {
    this.#cancelTimer?.();
    this.#cancelTimer = null;
    for (const [relay, bag] of this.#bags) {
      this.#send(relay, JSON.stringify(Object.fromEntries(bag)));
    }
    this.#bags.clear();
  }

  close(): void {
    this.#cancelTimer?.();
    this.#bags.clear();
  }
}

/** What a relay has sent, by robot; null when it cannot be read. */
export function readPost(text: string): Record<string, Snapshot> | null {
  const post: unknown = JSON.parse(text);
  return isPlainPost(post) ? post : (postSchema.safeParse(post).data ?? null);
}

/** Nearly all are; the schema judges the others. */
function isPlainPost(post: unknown): post is Record<string, Snapshot> {
  if (typeof post !== "object" || post === null || Array.isArray(post)) return false;
  return Object.values(post).every(isPlainSnapshot);
}
