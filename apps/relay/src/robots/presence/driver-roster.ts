/**
 * Scripts that use a robot, as its page shows them. Changes are reported at most once a second,
 * except new connections and changed permissions, which are reported immediately. The robot
 * continues a motion without an end only while the script that requested it is active. Each message
 * and request proves activity, and so does a request that waits for its response.
 */
import type { AliveDriver, CommandRecord, Drivers } from "@corridor/protocol";
import type { Scripts } from "../../bus/bus.ts";
import type { Clock } from "../../platform/time/clock.ts";
import { keyId } from "../../platform/keys.ts";
import type { StoredScript } from "../../store/port.ts";
import { limits } from "../../platform/limits/limits.ts";
import { ScriptList } from "./script-list.ts";

/** A script that is silent for longer than this holds no motion. */
const SILENT_MS = 10_000;
/** Maximum number of active scripts in a report. Motions of all others end. */
export const MAX_REPORTED = 16;

interface Life {
  lastActiveAt: number;
  /** requests that wait for their response */
  waiting: number;
  /** when its newest connection was opened; null: it has opened none */
  connectedAt: number | null;
}

export class DriverRoster {
  readonly #clock: Clock;
  readonly #notify: () => void;
  /** the same scripts by name */
  readonly #list: ScriptList;
  readonly #blocked: () => readonly StoredScript[];
  /** by the hash of the script's key */
  readonly #lives = new Map<string, Life>();
  #connected = 0;
  #client: string | null = null;
  #lastActiveAt: number | null = null;
  #cancelTimer: (() => void) | null = null;
  #hasChanged = false;

  /**
   * @param notify called when there is a change to report
   * @param blocked returns the scripts that the owner has blocked
   */
  constructor(clock: Clock, notify: () => void, blocked: () => readonly StoredScript[]) {
    this.#clock = clock;
    this.#notify = notify;
    this.#list = new ScriptList(clock);
    this.#blocked = blocked;
  }

  /** Records a message of a script that waits for no response. */
  spoke(script: StoredScript): void {
    const now = this.#clock.now();
    this.#lifeOf(script.driver, now);
    this.#list.spoke(script, now);
    this.#client = script.client;
    this.#lastActiveAt = now;
    this.#changed();
  }

  /** Records a request of a script. @returns function to call once the request is answered */
  received(script: StoredScript): () => void {
    const life = this.#lifeOf(script.driver);
    const listed = this.#list.received(script);
    this.#client = script.client;
    this.#lastActiveAt = this.#clock.now();
    life.waiting += 1;
    this.#changed();
    let isWaiting = true;
    return () => {
      if (!isWaiting) return;
      isWaiting = false;
      listed();
      life.waiting -= 1;
      life.lastActiveAt = this.#clock.now();
      this.#changed();
    };
  }

  /** Records an opened socket or stream of a script. @returns function to call when it closes */
  connected(script: StoredScript): () => void {
    this.#connected += 1;
    const listed = this.#list.connected(script);
    this.#lifeOf(script.driver).connectedAt = this.#clock.now();
    // Immediately, because commands that the script held while disconnected may follow.
    this.#flush();
    return () => {
      this.#connected -= 1;
      listed();
      this.#changed();
    };
  }

  /** Records an accepted command of a script. */
  sent(script: StoredScript, record: CommandRecord): void {
    this.#list.sent(script, record);
    this.#changed();
  }

  /** Reports changed permissions immediately, because the owner has just pressed a button. */
  blockedChanged(): void {
    this.#flush();
  }

  report(): Scripts {
    return { ...this.now(), alive: this.alive(), scripts: this.#list.report(this.#blocked()) };
  }

  now(): Drivers {
    const silentMs =
      this.#lastActiveAt === null ? null : Math.max(0, this.#clock.now() - this.#lastActiveAt);
    return { connected: this.#connected, client: this.#client, silentMs };
  }

  /** Scripts that may hold a motion. */
  alive(): AliveDriver[] {
    const now = this.#clock.now();
    return [...this.#lives]
      .map(([driver, { lastActiveAt, waiting, connectedAt }]) => ({
        driver: keyId(driver),
        silentMs: waiting > 0 ? 0 : Math.max(0, now - lastActiveAt),
        connectionMs: connectedAt === null ? null : Math.max(0, now - connectedAt),
      }))
      .toSorted((a, b) => a.silentMs - b.silentMs)
      .slice(0, MAX_REPORTED);
  }

  close(): void {
    this.#cancelTimer?.();
    this.#cancelTimer = null;
  }

  #lifeOf(driver: string, now = this.#clock.now()): Life {
    let life = this.#lives.get(driver);
    if (life === undefined) {
      life = { lastActiveAt: now, waiting: 0, connectedAt: null };
      this.#lives.set(driver, life);
    }
    life.lastActiveAt = now;
    return life;
  }

  #changed(): void {
    this.#hasChanged = true;
    if (this.#cancelTimer === null) this.#flush();
  }

  #flush(): void {
    this.#cancelTimer?.();
    this.#hasChanged = false;
    this.#removeSilent();
    this.#notify();
    this.#cancelTimer = this.#clock.after(limits.driversIntervalMs, () => {
      this.#cancelTimer = null;
      const isWaiting = [...this.#lives.values()].some(({ waiting }) => waiting > 0);
      if (this.#hasChanged || isWaiting) this.#flush();
    });
  }

  #removeSilent(): void {
    const before = this.#clock.now() - SILENT_MS;
    for (const [driver, { lastActiveAt, waiting }] of this.#lives) {
      if (waiting === 0 && lastActiveAt < before) this.#lives.delete(driver);
    }
  }
}
