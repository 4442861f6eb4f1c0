/**
 * Presence of the scripts that use a robot, as its page shows them: recently active, connected and
 * blocked ones, by name. The number of scripts in memory is bounded, whatever names they send.
 *
 * Changes are reported at most once a second, except new connections and changed permissions, which
 * are reported immediately. The robot continues a motion without an end only while a script with
 * the key that requested it is active. Each message and request proves activity, and so does a
 * request that waits for its response.
 */
import {
  MAX_SCRIPTS,
  type AliveDriver,
  type CommandRecord,
  type Drivers,
  type ScriptView,
} from "@corridor/protocol";
import type { Scripts } from "../../bus/bus.ts";
import type { Clock } from "../../platform/time/clock.ts";
import { keyId } from "../../platform/keys.ts";
import type { StoredScript } from "../../commands/robot-step.ts";
import { LastProblem } from "./last-problem.ts";
import { limits } from "../../platform/limits/limits.ts";

/** A key whose scripts are silent for longer than this holds no motion. */
const SILENT_MS = 10_000;
/** A disconnected script is no longer listed after this much silence. */
const LISTED_MS = 120_000;
/** Maximum number of active keys in a report. The motions of all others end. */
export const MAX_REPORTED = 16;

/** What is known about one script. */
interface Entry {
  script: StoredScript;
  connections: number;
  /** when its newest connection was opened; null: it has opened none */
  connectedAt: number | null;
  lastActiveAt: number;
  /** requests that wait for their response */
  waiting: number;
  /** its newest command */
  last: ScriptView["last"];
  readonly problem: LastProblem;
}

export class Presence {
  readonly #clock: Clock;
  #notify: () => void = () => undefined;
  /** by id, least recently active first */
  readonly #entries = new Map<string, Entry>();
  /** the most recently active one; most scripts send many messages in a row */
  #newest: Entry | null = null;
  /** the last message or request of any script */
  #latest: { client: string; at: number } | null = null;
  #cancelTimer: (() => void) | null = null;
  #hasChanged = false;

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  /** @param notify called when there is a change to report */
  onChange(notify: () => void): void {
    this.#notify = notify;
  }

  /** Records a message of a script that waits for no response. */
  spoke(script: StoredScript): void {
    this.#active(script);
    this.#changed();
  }

  /** Records a request of a script. @returns function to call once the request is answered */
  received(script: StoredScript): () => void {
    const entry = this.#active(script);
    entry.waiting += 1;
    this.#changed();
    let isWaiting = true;
    return () => {
      if (!isWaiting) return;
      isWaiting = false;
      entry.waiting -= 1;
      entry.lastActiveAt = this.#clock.now();
      this.#changed();
    };
  }

  /** Records an opened socket or stream of a script. @returns function to call when it closes */
  connected(script: StoredScript): () => void {
    const now = this.#clock.now();
    const entry = this.#entryOf(script, now);
    entry.connections += 1;
    entry.connectedAt = now;
    // Immediately, because commands that the script held while disconnected may follow.
    this.#flush();
    let isConnected = true;
    return () => {
      if (!isConnected) return;
      isConnected = false;
      entry.connections -= 1;
      this.#changed();
    };
  }

  /** Records an accepted command of a script. */
  sent(script: StoredScript, { seq, action }: CommandRecord): void {
    this.#entryOf(script, this.#clock.now()).last = { seq, action };
    this.#changed();
  }

  /** Records that the relay refused a command of a script. */
  refused(script: StoredScript, detail: string): void {
    const now = this.#clock.now();
    this.#entryOf(script, now).problem.record(detail, now);
    this.#changed();
  }

  /** Reports changed permissions immediately, because the owner has just pressed a button. */
  blockedChanged(): void {
    this.#flush();
  }

  /** Deletes the scripts of a revoked key, because they cannot return. @param driver its hash */
  keyRevoked(driver: string): void {
    for (const { script } of this.#entries.values()) {
      if (script.driver === driver) this.#entries.delete(script.id);
    }
    this.#newest = null;
    this.#flush();
  }

  /** @param blocked the scripts that the owner has blocked */
  report(blocked: readonly StoredScript[]): Scripts {
    return { ...this.now(), alive: this.#alive(), scripts: this.#listed(blocked) };
  }

  /** The summary for the page. */
  now(): Drivers {
    const latest = this.#latest;
    let connected = 0;
    for (const { connections } of this.#entries.values()) connected += connections;
    if (latest === null) return { connected, client: null, silentMs: null };
    const silentMs = Math.max(0, this.#clock.now() - latest.at);
    return { connected, client: latest.client, silentMs };
  }

  close(): void {
    this.#cancelTimer?.();
    this.#cancelTimer = null;
  }

  /** Keys that may hold a motion. */
  #alive(): AliveDriver[] {
    const now = this.#clock.now();
    const byKey = new Map<string, AliveDriver>();
    for (const entry of this.#entries.values()) {
      if (!isAlive(entry, now)) continue;
      const { driver } = entry.script;
      const other = byKey.get(driver);
      const connectionMs = least(ageOf(entry.connectedAt, now), other?.connectionMs ?? null);
      const silentMs = Math.min(silenceOf(entry, now), other?.silentMs ?? Infinity);
      byKey.set(driver, { driver: keyId(driver), silentMs, connectionMs });
    }
    return [...byKey.values()].toSorted((a, b) => a.silentMs - b.silentMs).slice(0, MAX_REPORTED);
  }

  /** Scripts by name. Blocked ones are listed first, whenever they were active. */
  #listed(blocked: readonly StoredScript[]): ScriptView[] {
    const now = this.#clock.now();
    const isBlocked = (id: string): boolean => blocked.some((script) => script.id === id);
    const here = [...this.#entries.values()]
      .filter(({ script, connections, waiting, lastActiveAt }) => {
        const isHere = connections > 0 || waiting > 0 || now - lastActiveAt < LISTED_MS;
        return isHere && !isBlocked(script.id);
      })
      .slice(-MAX_SCRIPTS)
      .map((entry) => ({
        ...view(entry.script),
        connections: entry.connections,
        silentMs: silenceOf(entry, now),
        last: entry.last,
        lastProblem: entry.problem.at(now),
        isBlocked: false,
      }));
    const gone = blocked.map((script) => ({
      ...view(script),
      connections: 0,
      silentMs: null,
      last: this.#entries.get(script.id)?.last ?? null,
      lastProblem: null,
      isBlocked: true,
    }));
    return [...gone, ...here];
  }

  /** The entry of a script that has just sent something. */
  #active(script: StoredScript): Entry {
    const at = this.#clock.now();
    this.#latest = { client: script.client, at };
    return this.#entryOf(script, at);
  }

  #entryOf(script: StoredScript, now: number): Entry {
    const known = this.#entries.get(script.id);
    const entry = known ?? {
      script,
      connections: 0,
      connectedAt: null,
      lastActiveAt: now,
      waiting: 0,
      last: null,
      problem: new LastProblem(),
    };
    entry.lastActiveAt = now;
    if (entry === this.#newest) return entry;
    this.#newest = entry;
    this.#entries.delete(script.id);
    this.#entries.set(script.id, entry);
    if (known === undefined) this.#deleteOldest(now);
    return entry;
  }

  /**
   * Bounds the memory for scripts that send ever new names. They never end the motion of another
   * key: the only entry of an active key remains.
   */
  #deleteOldest(now: number): void {
    if (this.#entries.size <= 2 * MAX_SCRIPTS) return;
    const all = [...this.#entries.values()];
    const isOnly = ({ script: { driver } }: Entry): boolean =>
      all.filter(({ script }) => script.driver === driver).length === 1;
    const oldest = all.find((entry) => {
      if (entry.connections > 0 || entry.waiting > 0) return false;
      return !isAlive(entry, now) || !isOnly(entry);
    });
    if (oldest !== undefined) this.#entries.delete(oldest.script.id);
  }

  #changed(): void {
    this.#hasChanged = true;
    if (this.#cancelTimer === null) this.#flush();
  }

  #flush(): void {
    this.#cancelTimer?.();
    this.#hasChanged = false;
    this.#notify();
    this.#cancelTimer = this.#clock.after(limits.driversIntervalMs, () => {
      this.#cancelTimer = null;
      const isDue = [...this.#entries.values()].some(
        ({ waiting, problem }) => waiting > 0 || problem.isPending,
      );
      if (this.#hasChanged || isDue) this.#flush();
    });
  }
}

function isAlive(entry: Entry, now: number): boolean {
  return silenceOf(entry, now) <= SILENT_MS;
}

function silenceOf({ waiting, lastActiveAt }: Entry, now: number): number {
  return waiting > 0 ? 0 : Math.max(0, now - lastActiveAt);
}

function ageOf(time: number | null, now: number): number | null {
  return time === null ? null : Math.max(0, now - time);
}

function least(a: number | null, b: number | null): number | null {
  return a === null || b === null ? (a ?? b) : Math.min(a, b);
}

function view({ id, driver, name, client }: StoredScript) {
  return { id, driver: keyId(driver), name, client };
}
