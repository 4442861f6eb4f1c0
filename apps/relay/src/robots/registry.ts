/**
 * All robot sessions of this relay: creates, finds and deletes them. A session is held in memory
 * while it is in use. The store holds the rest.
 */
import type { Registration } from "@corridor/protocol";
import type { Logger } from "pino";
import type { Clock } from "../platform/time/clock.ts";
import { LocalSwitchboard } from "../bus/local.ts";
import type { Switchboard } from "../bus/bus.ts";
import { canBeKey, hashKey, mintId, mintKey } from "../platform/keys.ts";
import {
  noRobot,
  notAuthorised,
  Refusal,
  retryAfter,
  restarting,
} from "../platform/errors/problems.ts";
import type { SessionStore, StoredKey } from "../store/port.ts";
import type { ReaderDoor } from "./readers/subscribers.ts";
import { CoalescedTimers } from "../platform/time/coalesced-timers.ts";
import { StaggeredInterval } from "../platform/time/staggered-interval.ts";
import { limits } from "../platform/limits/limits.ts";
import { checkRight, type Verb } from "./access/rights.ts";
import { callerOf, unknownScript, type Caller, type Introduction } from "./access/caller.ts";
import { Session } from "./robot.ts";
import { TokenBucket } from "../platform/limits/token-bucket.ts";
import { noWitness, type Witness } from "./delivery/witness.ts";

const LIFE_CHECK_MS = 1_000;
const EXPIRY_CHECK_MS = 60_000;
/**
 * Share of the robots whose uses are stored in one second, and a lower bound for their number. If a
 * class starts to use all its robots at once, their commands must not wait for that.
 */
const NOTED_SHARE = 1 / 30;
const NOTED_AT_LEAST = 10;

/** Current numbers of pages and readers, for gauges. */
export interface Census {
  /** robots with a page at this relay */
  pages: number;
  readers: Record<ReaderDoor, number>;
}

/** Optional parts of a hub. */
export interface HubOptions {
  /** metrics observer of commands; default: none */
  witness?: Witness;
  /** message bus to other relays; default: a local one */
  switchboard?: Switchboard;
}

export interface Grant {
  session: Session;
  key: Caller;
}

export class SessionHub {
  readonly #store: SessionStore;
  readonly #clock: Clock;
  readonly #timers: CoalescedTimers;
  readonly #log: Logger;
  readonly #witness: Witness;
  readonly #switchboard: Switchboard;
  readonly #sessions = new Map<string, Promise<Session | null>>();
  /** by address; in memory only */
  readonly #registrations = new Map<string, TokenBucket>();
  readonly #lives: StaggeredInterval<[id: string, found: Promise<Session | null>]>;
  #cancelExpiry: () => void;
  #isClosing = false;
  /** number of sessions whose use may still be stored before the next pass */
  #notesLeft = 0;

  constructor(store: SessionStore, clock: Clock, log: Logger, options: HubOptions = {}) {
    this.#store = store;
    this.#clock = clock;
    this.#timers = new CoalescedTimers(clock);
    this.#log = log;
    this.#witness = options.witness ?? noWitness;
    this.#switchboard = options.switchboard ?? new LocalSwitchboard();
    this.#lives = new StaggeredInterval({
      clock,
      everyMs: LIFE_CHECK_MS,
      members: () => {
        this.#rationNotes();
        return this.#sessions;
      },
      visit: ([id, found]) => this.#tried(this.#checkLife(id, found)),
    });
    this.#cancelExpiry = clock.after(LIFE_CHECK_MS, () => void this.#expire());
  }

  get clock(): Clock {
    return this.#clock;
  }

  /**
   * Registers a new robot.
   * @param from address of the client, for the rate limit only
   * @param origin public origin of the service, such as https://host
   * @throws Refusal too-fast or restarting
   */
  async register(from: string, origin: string): Promise<Registration> {
    if (this.#isClosing) throw restarting();
    const now = this.#clock.now();
    const bucket = this.#registrations.get(from) ?? new TokenBucket(limits.registrationRate, now);
    this.#registrations.set(from, bucket);
    const waitMs = bucket.take(now);
    if (waitMs > 0) {
      throw new Refusal(
        "too-fast",
        "Too many robots were registered from this network. Wait a moment, then try again.",
        { headers: retryAfter(waitMs) },
      );
    }
    const id = mintId();
    const ownerKey = mintKey("own");
    const driverKey = mintKey("drive");
    const keys: StoredKey[] = [
      { kind: "own", hash: hashKey(ownerKey) },
      { kind: "drive", hash: hashKey(driverKey) },
    ];
    await this.#store.create({ id, createdAt: now, keys });
    return { id, ownerKey, driverKey, address: `${origin}/r/${id}#${driverKey}` };
  }

  /**
   * Finds the session and checks the permissions of the key.
   * @param introduction what a script sends about itself
   * @throws Refusal no-robot, not-authorised, forbidden, blocked or restarting
   */
  async authorise(
    id: string,
    key: string | null,
    verb: Verb,
    introduction: Introduction = unknownScript,
  ): Promise<Grant> {
    // A client discards a rejected key for good, so a restart must not reject it.
    if (this.#isClosing) throw restarting();
    // Without a key, the response must not reveal which robots exist.
    if (!canBeKey(key)) throw wrongKey(key);
    const session = await this.#find(id);
    if (this.#isClosing) throw restarting();
    if (session === null) throw noRobot();
    const stored = session.grantOf(key);
    if (stored === null) throw wrongKey(key);
    checkRight(stored.kind, verb);
    const caller = callerOf(stored, introduction);
    session.gate.check(caller);
    return { session, key: caller };
  }

  async census(): Promise<Census> {
    const census: Census = {
      pages: 0,
      readers: { websocket: 0, line: 0, events: 0, "long-poll": 0 },
    };
    for (const found of this.#sessions.values()) {
      const session = await found.catch(() => null);
      if (session === null) continue;
      if (session.hasPage) census.pages += 1;
      const { websocket, line, events, "long-poll": waiting } = session.readers.count;
      census.readers.websocket += websocket;
      census.readers.line += line;
      census.readers.events += events;
      census.readers["long-poll"] += waiting;
    }
    return census;
  }

  /** Deletes a session with all its stored data, and disconnects all clients. */
  async remove(session: Session): Promise<void> {
    session.close("over");
    this.#sessions.delete(session.id);
    await this.#store.remove(session.id);
  }

  /** Disconnects all clients because the relay stops. Stored data remains. */
  async close(): Promise<void> {
    this.#isClosing = true;
    this.#lives.close();
    this.#cancelExpiry();
    const sessions = [...this.#sessions.values()];
    this.#sessions.clear();
    for (const found of sessions) (await found.catch(() => null))?.close("restart");
  }

  async #find(id: string): Promise<Session | null> {
    let found = this.#sessions.get(id);
    if (found === undefined) {
      found = this.#load(id);
      this.#sessions.set(id, found);
      // Unknown ids and failed reads are not cached.
      const forget = (): void => void this.#sessions.delete(id);
      void found.then((session) => session === null && forget(), forget);
    }
    return found;
  }

  async #load(id: string): Promise<Session | null> {
    const stored = await this.#store.find(id);
    if (stored === null) return null;
    return Session.open(stored, {
      store: this.#store,
      clock: this.#clock,
      timers: this.#timers,
      witness: this.#witness,
      switchboard: this.#switchboard,
      forgotten: () => this.#sessions.delete(id),
    });
  }

  /** Schedules the next run after the end of this one, because a deletion may take long. */
  async #expire(): Promise<void> {
    await this.#tried(this.#checkExpiry());
    if (this.#isClosing) return;
    this.#cancelExpiry = this.#clock.after(EXPIRY_CHECK_MS, () => void this.#expire());
  }

  /** Logs a failure. It does not affect other sessions, and the next pass retries the work. */
  async #tried(work: Promise<void>): Promise<void> {
    try {
      await work;
    } catch (error) {
      this.#log.error({ err: error }, "session cleanup failed");
    }
  }

  #rationNotes(): void {
    this.#notesLeft = Math.max(NOTED_AT_LEAST, Math.ceil(this.#sessions.size * NOTED_SHARE));
  }

  async #checkLife(id: string, found: Promise<Session | null>): Promise<void> {
    const session = await found.catch(() => null);
    if (session === null || session.isOver) return;
    await session.checkLife();
    if (session.isUseDue) {
      if (this.#notesLeft <= 0) return;
      this.#notesLeft -= 1;
      await session.noteUse();
    }
    if (!session.isQuiet || session.isOver) return;
    if (this.#sessions.get(id) === found) this.#sessions.delete(id);
    session.leave();
  }

  async #checkExpiry(): Promise<void> {
    const now = this.#clock.now();
    for (const [from, bucket] of this.#registrations) {
      if (bucket.isFull(now)) this.#registrations.delete(from);
    }
    await this.#noteUrgent();
    const ids = await this.#store.removeExpired({
      lastUsedAt: now - limits.sessionIdleMs,
      createdAt: now - limits.sessionLifeMs,
    });
    for (const id of ids) {
      const session = await this.#sessions.get(id);
      session?.close("over");
      this.#sessions.delete(id);
    }
    if (ids.length > 0) this.#log.info({ count: ids.length }, "deleted expired sessions");
  }

  /** Stores uses before the deletion, so that no session in use expires. */
  async #noteUrgent(): Promise<void> {
    const urgent: Promise<void>[] = [];
    for (const found of this.#sessions.values()) {
      const session = await found.catch(() => null);
      if (session?.isUseUrgent === true) urgent.push(session.noteUse());
    }
    await Promise.all(urgent);
  }
}

/**
 * @param key as sent; null: none. Client libraries always send a key, so only the text for a
 * missing key names the header.
 */
function wrongKey(key: string | null): Refusal {
  return notAuthorised(
    key === null
      ? "Send the robot's key, the part of its address after the #, as: Authorization: Bearer KEY"
      : "The key is invalid or was revoked. Copy the whole address again, with the part after the #: press 'Copy address with key' under Remote on the robot's page.",
  );
}
