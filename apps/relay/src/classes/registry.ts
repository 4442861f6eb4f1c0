/**
 * All classes of this relay: creates, finds and deletes them, and admits students. A class is held
 * in memory while it is in use. The store holds the rest.
 */
import {
  classRoles,
  type ClassRole,
  type CreatedClass,
  type JoinedClass,
} from "@corridor/protocol";
import type { Logger } from "pino";
import type { ClassBus } from "../bus/class-bus.ts";
import { canBeKey, hashKey, mintClassCode, mintId, mintKey, mintStream } from "../platform/keys.ts";
import { noClass, Refusal, restarting, retryAfter } from "../platform/errors/problems.ts";
import { CheckQueue } from "../platform/limits/check-queue.ts";
import { KeyedRateLimiter } from "../platform/limits/keyed-rate-limiter.ts";
import { limits } from "../platform/limits/limits.ts";
import type { Clock } from "../platform/time/clock.ts";
import type { ClassRow, ClassStore, FoundCode } from "../store/class-store.ts";
import { checkClassRight, wrongClassKey, type ClassVerb, type Member } from "./access.ts";
import { LiveClass } from "./live-class.ts";
import { joinStep, returnStep, wrongCode } from "./student-steps.ts";

const EXPIRY_CHECK_MS = 60_000;
const VERSION_LENGTH = 22;

/** What a teacher sends for a new class. */
export interface ClassRequest {
  names: readonly string[] | null;
  expected: number | null;
  /** the document as JSON */
  lesson: string;
}

/** What is connected to this relay. */
export interface ClassCounts {
  /** classes with a connection */
  classes: number;
  /** connections by role */
  members: Record<ClassRole, number>;
}

export interface ClassGrant {
  found: LiveClass;
  member: Member;
}

export class ClassRegistry {
  readonly #store: ClassStore;
  readonly #bus: ClassBus;
  readonly #clock: Clock;
  readonly #log: Logger;
  readonly #checks: CheckQueue;
  readonly #classes = new Map<string, Promise<LiveClass | null>>();
  /** by address; in memory only */
  readonly #creations: KeyedRateLimiter;
  readonly #joins: KeyedRateLimiter;
  #cancelTimer: () => void;
  #isClosing = false;

  constructor(parts: { store: ClassStore; bus: ClassBus; clock: Clock; log: Logger }) {
    this.#store = parts.store;
    this.#bus = parts.bus;
    this.#clock = parts.clock;
    this.#log = parts.log;
    this.#creations = new KeyedRateLimiter(parts.clock, limits.classRate);
    this.#joins = new KeyedRateLimiter(parts.clock, limits.joinRate);
    this.#checks = new CheckQueue(parts.clock, limits.codeChecks, limits.codeChecksForAll);
    this.#cancelTimer = parts.clock.after(EXPIRY_CHECK_MS, () => void this.#expire());
  }

  /**
   * Creates a class.
   * @param from address of the client, for the rate limit only
   * @param origin public origin of the service, such as https://host
   * @throws Refusal too-fast or restarting
   */
  async create(request: ClassRequest, from: string, origin: string): Promise<CreatedClass> {
    if (this.#isClosing) throw restarting();
    limitRate(this.#creations, from, "Too many classes were created");
    const id = mintId();
    const [teacherKey, screenKey] = [mintKey("teach"), mintKey("show")];
    for (;;) {
      const code = mintClassCode();
      const row: ClassRow = {
        version: 0,
        n: 0,
        stream: mintStream(),
        createdAt: this.#clock.now(),
        names: request.names,
        expected: request.expected,
        keys: [
          { kind: "teach", hash: hashKey(teacherKey) },
          { kind: "show", hash: hashKey(screenKey) },
        ],
        code,
        isLocked: false,
        pause: null,
        pausedMs: 0,
        paceTo: null,
        lessonVersion: lessonVersionOf(request.lesson),
        lastStudent: 0,
      };
      const created = { id, row, lesson: request.lesson, code: hashKey(code) };
      if (!(await this.#store.create(created))) continue;
      const address = `${origin}/class/${id}#${teacherKey}`;
      const endsInSeconds = limits.classLifeMs / 1_000;
      return { id, code, teacherKey, screenKey, address, endsInSeconds };
    }
  }

  /**
   * Admits a new student, or a student who returns on another device.
   * @throws Refusal no-class, class-locked, class-full or too-fast
   */
  async join(code: string, from: string): Promise<JoinedClass> {
    if (this.#isClosing) throw restarting();
    const hash = hashKey(code);
    const found = await this.#checks.run(from, hash, async () => this.#validCode(hash));
    if (found === null) throw wrongCode();
    limitRate(this.#joins, from, "Too many students joined");
    const joinedClass = await this.#find(found.id);
    if (joinedClass === null) throw wrongCode();
    joinedClass.used();
    const key = mintKey("learn");
    const keyHash = hashKey(key);
    const { student, name } = await joinedClass.run(
      found.student === null ? joinStep(keyHash, hash) : returnStep(found.student, keyHash, hash),
    );
    return { class: found.id, student, name, key };
  }

  /**
   * Finds the class and checks the permissions of the key.
   * @throws Refusal no-class, not-authorised, forbidden or restarting
   */
  async authorise(id: string, key: string | null, verb: ClassVerb): Promise<ClassGrant> {
    // A client discards a rejected key for good, so a restart must not reject it.
    if (this.#isClosing) throw restarting();
    if (!canBeKey(key)) throw wrongClassKey(key);
    const found = await this.#find(id);
    if (this.#isClosing) throw restarting();
    if (found === null) throw noClass();
    const member = await found.memberOf(key);
    if (member === null) throw wrongClassKey(key);
    checkClassRight(member.kind, verb);
    found.used();
    return { found, member };
  }

  async connectionCounts(): Promise<ClassCounts> {
    const members = { learn: 0, teach: 0, show: 0 };
    let classes = 0;
    for (const pending of this.#classes.values()) {
      const found = await pending.catch(() => null);
      if (found === null || found.connections.isEmpty) continue;
      classes += 1;
      for (const role of classRoles) members[role] += found.connections.counts[role];
    }
    return { classes, members };
  }

  /** Deletes a class with all its stored data. */
  async remove(ended: LiveClass): Promise<void> {
    await this.#store.remove(ended.id);
    this.#classes.delete(ended.id);
    ended.over();
  }

  async close(): Promise<void> {
    this.#isClosing = true;
    this.#cancelTimer();
    this.#checks.close();
    const classes = [...this.#classes.values()];
    this.#classes.clear();
    for (const each of classes) (await each.catch(() => null))?.leave();
  }

  async #validCode(hash: string): Promise<FoundCode | null> {
    const found = await this.#store.findCode(hash);
    const hasEnded = found !== null && found.endsAt !== null && found.endsAt <= this.#clock.now();
    return hasEnded ? null : found;
  }

  async #find(id: string): Promise<LiveClass | null> {
    const known = this.#classes.get(id);
    if (known !== undefined) return known;
    const opened = LiveClass.open(id, {
      store: this.#store,
      bus: this.#bus,
      clock: this.#clock,
      ended: () => void this.#ended(id, opened),
    });
    this.#classes.set(id, opened);
    // Unknown ids and failed reads are not cached.
    const drop = (): void => void this.#classes.delete(id);
    void opened.then((found) => found === null && drop(), drop);
    return opened;
  }

  async #ended(id: string, ended: Promise<LiveClass | null>): Promise<void> {
    if (this.#classes.get(id) === ended) this.#classes.delete(id);
    (await ended.catch(() => null))?.end();
  }

  /** Schedules the next run after the end of this one, because a deletion may take long. */
  async #expire(): Promise<void> {
    try {
      await this.#checkExpiry();
    } catch (error) {
      this.#log.error({ err: error }, "deleting expired classes failed");
    }
    if (this.#isClosing) return;
    this.#cancelTimer = this.#clock.after(EXPIRY_CHECK_MS, () => void this.#expire());
  }

  async #checkExpiry(): Promise<void> {
    const now = this.#clock.now();
    // Uses are stored before the deletion, so that no class in use expires.
    for (const [id, pending] of this.#classes) {
      const found = await pending.catch(() => null);
      await found?.noteUse();
      if (found?.isQuiet !== true) continue;
      this.#classes.delete(id);
      found.leave();
    }
    const ids = await this.#store.removeExpired({
      lastUsedAt: now - limits.classIdleMs,
      createdAt: now - limits.classLifeMs,
    });
    for (const id of ids) {
      const found = this.#classes.get(id);
      if (found !== undefined) await this.#ended(id, found);
    }
    if (ids.length > 0) this.#log.info({ count: ids.length }, "deleted expired classes");
  }
}

/** The version of a lesson: equal for equal texts, at every relay. */
export function lessonVersionOf(text: string): string {
  return hashKey(text).slice(0, VERSION_LENGTH);
}

function limitRate(limiter: KeyedRateLimiter, from: string, what: string): void {
  const waitMs = limiter.take(from);
  if (waitMs === 0) return;
  const detail = `${what} from this network. Wait a moment, then try again.`;
  throw new Refusal("too-fast", detail, { headers: retryAfter(waitMs) });
}
