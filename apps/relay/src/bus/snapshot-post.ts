/**
 * Batches snapshots for other relays: one message every 15 ms contains the snapshots of all robots
 * that a relay needs. One message per snapshot would cost both relays more than all other work for
 * it.
 *
 * A post is one JSON object with the latest snapshot by robot. Snapshots are copied as bytes,
 * without parsing them at either relay.
 */
import { findSnapshot, snapshotSchema } from "@corridor/protocol";
import { z } from "zod";
import type { Clock } from "../platform/time/clock.ts";
import { CarriedSnapshot } from "./carried-snapshot.ts";

const BATCH_MS = 15;
const END = Buffer.from("}");

const postSchema = z.record(z.string(), snapshotSchema);

export class SnapshotPost {
  readonly #clock: Clock;
  readonly #send: (relay: string, post: Buffer) => void;
  /** by relay, the latest snapshot of each robot */
  readonly #batches = new Map<string, Map<string, CarriedSnapshot>>();
  #cancelTimer: (() => void) | null = null;

  /** @param send sends a post to one relay; delivery is not guaranteed */
  constructor(clock: Clock, send: (relay: string, post: Buffer) => void) {
    this.#clock = clock;
    this.#send = send;
  }

  post(robot: string, snapshot: CarriedSnapshot, relays: Iterable<string>): void {
    for (const relay of relays) {
      const batch = this.#batches.get(relay) ?? new Map<string, CarriedSnapshot>();
      this.#batches.set(relay, batch.set(robot, snapshot));
    }
    this.#cancelTimer ??= this.#clock.after(BATCH_MS, () => this.flush());
  }

  /** Sends the pending snapshots. */
  flush(): void {
    this.#cancelTimer?.();
    this.#cancelTimer = null;
    for (const [relay, batch] of this.#batches) this.#send(relay, encode(batch));
    this.#batches.clear();
  }

  close(): void {
    this.#cancelTimer?.();
    this.#batches.clear();
  }
}

function encode(batch: ReadonlyMap<string, CarriedSnapshot>): Buffer {
  const parts: Buffer[] = [];
  for (const [robot, { json }] of batch) {
    parts.push(Buffer.from(`${parts.length === 0 ? "{" : ","}"${robot}":`, "latin1"), json);
  }
  return Buffer.concat([...parts, END]);
}

/** Decodes a post to snapshots by robot. Returns null if it is invalid. */
export function readPost(post: Buffer): ReadonlyMap<string, CarriedSnapshot> | null {
  return readFastPost(post) ?? readAnyPost(post);
}

/** Fast path for posts in the format of `encode`. Returns null for all others. */
function readFastPost(post: Buffer): Map<string, CarriedSnapshot> | null {
  const text = post.toString("latin1");
  const found = new Map<string, CarriedSnapshot>();
  for (let at = 0; text.charAt(at) === (at === 0 ? "{" : ",");) {
    const endOfName = text.indexOf('":', at);
    const isName = text.charAt(at + 1) === '"' && endOfName > 0;
    const place = !isName ? null : findSnapshot(text, endOfName + 2);
    if (place === null) return null;
    // The name needs no check, because no robot has an invalid name.
    found.set(text.slice(at + 2, endOfName), CarriedSnapshot.found(post, place));
    if (text.charAt(place.end) === "}") return place.end === text.length - 1 ? found : null;
    at = place.end;
  }
  return null;
}

function readAnyPost(post: Buffer): Map<string, CarriedSnapshot> | null {
  const { data } = postSchema.safeParse(parseJson(post));
  if (data === undefined) return null;
  return new Map(Object.entries(data).map(([robot, value]) => [robot, CarriedSnapshot.of(value)]));
}

function parseJson(post: Buffer): unknown {
  try {
    return JSON.parse(post.toString());
  } catch {
    return null;
  }
}
