/**
 * Snapshots on their way to other relays: those of all robots that one relay wants, in one message every
 * 15 ms. A message for each would cost both relays more than all else that they do with it.
 *
 * A post is one JSON object, the newest snapshot by robot. Each is put in as it came from its page and taken
 * out as it is, without an object being made of it at either relay.
 */
import { findSnapshot, snapshotSchema } from "@corridor/protocol";
import { z } from "zod";
import type { Clock } from "../clock.ts";
import { CarriedSnapshot } from "../sessions/carried-snapshot.ts";

const GATHER_MS = 15;
const END = Buffer.from("}");

const postSchema = z.record(z.string(), snapshotSchema);

export class SnapshotPost {
  readonly #clock: Clock;
  readonly #send: (relay: string, post: Buffer) => void;
  /** by relay, the newest of each robot */
  readonly #bags = new Map<string, Map<string, CarriedSnapshot>>();
  #cancelTimer: (() => void) | null = null;

  /** @param send takes a post to one relay, or loses it */
  constructor(clock: Clock, send: (relay: string, post: Buffer) => void) {
    this.#clock = clock;
    this.#send = send;
  }

  post(robot: string, snapshot: CarriedSnapshot, relays: Iterable<string>): void {
    for (const relay of relays) {
      const bag = this.#bags.get(relay) ?? new Map<string, CarriedSnapshot>();
      this.#bags.set(relay, bag.set(robot, snapshot));
    }
    this.#cancelTimer ??= this.#clock.after(GATHER_MS, () => this.flush());
  }

  /** Sends what was gathered. */
  flush(): void {
    this.#cancelTimer?.();
    this.#cancelTimer = null;
    for (const [relay, bag] of this.#bags) this.#send(relay, written(bag));
    this.#bags.clear();
  }

  close(): void {
    this.#cancelTimer?.();
    this.#bags.clear();
  }
}

function written(bag: ReadonlyMap<string, CarriedSnapshot>): Buffer {
  const parts: Buffer[] = [];
  for (const [robot, { json }] of bag) {
    parts.push(Buffer.from(`${parts.length === 0 ? "{" : ","}"${robot}":`, "latin1"), json);
  }
  return Buffer.concat([...parts, END]);
}

/** What a relay has sent, by robot; null when it cannot be read. */
export function readPost(post: Buffer): ReadonlyMap<string, CarriedSnapshot> | null {
  return readPlainPost(post) ?? readAnyPost(post);
}

/** A post as it is written above, of snapshots without anything unusual; null for all else. */
function readPlainPost(post: Buffer): Map<string, CarriedSnapshot> | null {
  const text = post.toString("latin1");
  const found = new Map<string, CarriedSnapshot>();
  for (let at = 0; text.charAt(at) === (at === 0 ? "{" : ",");) {
    const endOfName = text.indexOf('":', at);
    const isName = text.charAt(at + 1) === '"' && endOfName > 0;
    const place = !isName ? null : findSnapshot(text, endOfName + 2);
    if (place === null) return null;
    // Whatever stands there: nobody has a robot of any other name than robots have.
    found.set(text.slice(at + 2, endOfName), CarriedSnapshot.found(post, place));
    if (text.charAt(place.end) === "}") return place.end === text.length - 1 ? found : null;
    at = place.end;
  }
  return null;
}

function readAnyPost(post: Buffer): Map<string, CarriedSnapshot> | null {
  const { data } = postSchema.safeParse(parsed(post));
  if (data === undefined) return null;
  return new Map(Object.entries(data).map(([robot, value]) => [robot, CarriedSnapshot.of(value)]));
}

function parsed(post: Buffer): unknown {
  try {
    return JSON.parse(post.toString());
  } catch {
    return null;
  }
}
