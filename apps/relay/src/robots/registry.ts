/**
 * All robots of this relay: creates, finds and deletes them. A robot is held in memory
 * while it is in use. The store holds the rest.
 */
import { keyPrefixes, WRONG_KEY, type Registration } from "@corridor/protocol";
import type { Logger } from "pino";
import type { Clock } from "../platform/time/clock.ts";
import { LocalBus } from "../bus/local.ts";
import type { Bus } from "../bus/bus.ts";
import { canBeKey, hashKey, mintId, mintKey } from "../platform/keys.ts";
import {
  noRobot,
  notAuthorised,
  Refusal,
  retryAfter,
  restarting,
} from "../platform/errors/problems.ts";
import type { RobotStore } from "../store/robot-store.ts";
import type { StoredKey } from "../commands/robot-step.ts";
import { readerTransports, type ReaderTransport } from "./readers/subscribers.ts";
import { CoalescedTimers } from "../platform/time/coalesced-timers.ts";
import { StaggeredInterval } from "../platform/time/staggered-interval.ts";
import { limits } from "../platform/limits/limits.ts";
import {
  checkRight,
  callerOf,
  unknownScript,
  type Verb,
  type Caller,
  type Introduction,
} from "./access/callers.ts";
import { Robot } from "./robot.ts";
import { KeyedRateLimiter } from "../platform/limits/keyed-rate-limiter.ts";
import { noObserver, type CommandObserver } from "./delivery/command-observer.ts";

const LIFE_CHECK_MS = 1_000;
const EXPIRY_CHECK_MS = 60_000;
/**
 * Share of the robots whose uses are stored in one second, and a lower bound for their number. If a
 * class starts to use all its robots at once, their commands must not wait for that.
 */
const NOTED_SHARE = 1 / 30;
const NOTED_AT_LEAST = 10;

/** Current numbers of pages and readers, for gauges. */
export interface ConnectionCounts {
  /** robots with a page at this relay */
  pages: number;
  readers: Record<ReaderTransport, number>;
}

/** Optional parts of a registry. */
export interface RegistryOptions {
  /** metrics observer of commands; default: none */
  observer?: CommandObserver;
  /** message bus to other relays; default: a local one */
  bus?: Bus;
}

export interface Grant {
  robot: Robot;
  caller: Caller;
}

const URL_KEY_ELSEWHERE =
  "A key that starts with url_ works only in the path of the URL that it was made for. For scripts, copy the address with its key: press 'Copy address with key' under Remote on the robot's page.";

const WRONG_IN_URL =
  "The key in the path of this URL is invalid or was revoked. Copy the whole URL again from the robot's page. A path accepts only keys that start with url_.";

export class RobotRegistry {
  readonly #store: RobotStore;
  readonly #clock: Clock;
  readonly #timers: CoalescedTimers;
  readonly #log: Logger;
  readonly #observer: CommandObserver;
  readonly #bus: Bus;
  readonly #robots = new Map<string, Promise<Robot | null>>();
  /** by address; in memory only */
  readonly #registrations: KeyedRateLimiter;
  readonly #lives: StaggeredInterval<[id: string, found: Promise<Robot | null>]>;
  #cancelExpiry: () => void;
  #isClosing = false;
  /** number of robots whose use may still be stored before the next pass */
  #notesLeft = 0;

  constructor(store: RobotStore, clock: Clock, log: Logger, options: RegistryOptions = {}) {
    this.#store = store;
    this.#clock = clock;
    this.#timers = new CoalescedTimers(clock);
    this.#registrations = new KeyedRateLimiter(clock, limits.registrationRate);
    this.#log = log;
    this.#observer = options.observer ?? noObserver;
    this.#bus = options.bus ?? new LocalBus();
    this.#lives = new StaggeredInterval({
      clock,
      everyMs: LIFE_CHECK_MS,
      members: () => {
        this.#rationNotes();
        return this.#robots;
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
    const waitMs = this.#registrations.take(from);
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
    await this.#store.create({ id, createdAt: this.#clock.now(), keys });
    return { id, ownerKey, driverKey, address: `${origin}/r/${id}#${driverKey}` };
  }

  /**
   * Finds the robot and checks the permissions of the key.
   * @param introduction what a script sends about itself
   * @param use where the key stood: in a header or message by default
   * @throws Refusal no-robot, not-authorised, forbidden, blocked or restarting
   */
  async authorise(
    id: string,
    key: string | null,
    verb: Verb,
    introduction: Introduction = unknownScript,
    use?: StoredKey["use"],
  ): Promise<Grant> {
    // A client discards a rejected key for good, so a restart must not reject it.
    if (this.#isClosing) throw restarting();
    // Without a key, the response must not reveal which robots exist.
    if (!canBeKey(key)) throw wrongKey(key, use);
    const robot = await this.#find(id);
    if (this.#isClosing) throw restarting();
    if (robot === null) throw noRobot();
    const stored = robot.grantOf(key, use);
    if (stored === null) throw wrongKey(key, use);
    checkRight(stored.kind, verb);
    const caller = callerOf(stored, introduction);
    robot.scriptAccess.check(caller);
    return { robot, caller };
  }

  async connectionCounts(): Promise<ConnectionCounts> {
    const connectionCounts: ConnectionCounts = {
      pages: 0,
      readers: { websocket: 0, "long-poll-connection": 0, events: 0, "long-poll": 0 },
    };
    for (const found of this.#robots.values()) {
      const robot = await found.catch(() => null);
      if (robot === null) continue;
      if (robot.hasPage) connectionCounts.pages += 1;
      for (const transport of readerTransports) {
        connectionCounts.readers[transport] += robot.readers.count[transport];
      }
    }
    return connectionCounts;
  }

  /** Deletes a robot with all its stored data, and disconnects all clients. */
  async remove(robot: Robot): Promise<void> {
    // First of all, so that a client that reconnects, here or to another relay, finds no robot.
    await this.#store.remove(robot.id);
    this.#robots.delete(robot.id);
    robot.close("over");
  }

  /** Disconnects all clients because the relay stops. Stored data remains. */
  async close(): Promise<void> {
    this.#isClosing = true;
    this.#lives.close();
    this.#cancelExpiry();
    const robots = [...this.#robots.values()];
    this.#robots.clear();
    for (const found of robots) (await found.catch(() => null))?.close("restart");
  }

  async #find(id: string): Promise<Robot | null> {
    let found = this.#robots.get(id);
    if (found === undefined) {
      found = this.#load(id);
      this.#robots.set(id, found);
      // Unknown ids and failed reads are not cached.
      const remove = (): void => void this.#robots.delete(id);
      void found.then((robot) => robot === null && remove(), remove);
    }
    return found;
  }

  async #load(id: string): Promise<Robot | null> {
    const stored = await this.#store.find(id);
    if (stored === null) return null;
    return Robot.open(stored, {
      store: this.#store,
      clock: this.#clock,
      timers: this.#timers,
      observer: this.#observer,
      bus: this.#bus,
      deleted: () => this.#robots.delete(id),
    });
  }

  /** Schedules the next run after the end of this one, because a deletion may take long. */
  async #expire(): Promise<void> {
    await this.#tried(this.#checkExpiry());
    if (this.#isClosing) return;
    this.#cancelExpiry = this.#clock.after(EXPIRY_CHECK_MS, () => void this.#expire());
  }

  /** Logs a failure. It does not affect other robots, and the next pass retries the work. */
  async #tried(work: Promise<void>): Promise<void> {
    try {
      await work;
    } catch (error) {
      this.#log.error({ err: error }, "cleaning up robots failed");
    }
  }

  #rationNotes(): void {
    this.#notesLeft = Math.max(NOTED_AT_LEAST, Math.ceil(this.#robots.size * NOTED_SHARE));
  }

  async #checkLife(id: string, found: Promise<Robot | null>): Promise<void> {
    const robot = await found.catch(() => null);
    if (robot === null || robot.isOver) return;
    await robot.checkLife();
    if (robot.use.isDue) {
      if (this.#notesLeft <= 0) return;
      this.#notesLeft -= 1;
      await robot.use.note();
    }
    if (!robot.isQuiet || robot.isOver) return;
    if (this.#robots.get(id) === found) this.#robots.delete(id);
    robot.leave();
  }

  async #checkExpiry(): Promise<void> {
    const now = this.#clock.now();
    await this.#noteUrgent();
    const ids = await this.#store.removeExpired({
      lastUsedAt: now - limits.robotIdleMs,
      createdAt: now - limits.robotLifeMs,
    });
    for (const id of ids) {
      const robot = await this.#robots.get(id)?.catch(() => null);
      robot?.close("over");
      this.#robots.delete(id);
    }
    if (ids.length > 0) this.#log.info({ count: ids.length }, "deleted expired robots");
  }

  /** Stores uses before the deletion, so that no robot in use expires. */
  async #noteUrgent(): Promise<void> {
    const urgent: Promise<void>[] = [];
    for (const found of this.#robots.values()) {
      const robot = await found.catch(() => null);
      if (robot?.use.isUrgent === true) urgent.push(robot.use.note());
    }
    await Promise.all(urgent);
  }
}

/**
 * @param key as sent; null: none. Client libraries always send a key, so only the text for a
 * missing key names the header.
 */
function wrongKey(key: string | null, use: StoredKey["use"]): Refusal {
  if (use === "url") return notAuthorised(WRONG_IN_URL);
  if (key?.startsWith(keyPrefixes.url) === true) return notAuthorised(URL_KEY_ELSEWHERE);
  return notAuthorised(
    key === null
      ? "Send the robot's key, the part of its address after the #, as: Authorization: Bearer KEY"
      : WRONG_KEY,
  );
}
