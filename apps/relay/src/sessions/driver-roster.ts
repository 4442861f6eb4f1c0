/**
 * Which scripts use a robot, as its page shows them; told at most once a second. The robot goes on with
 * a motion without an end only while the script that wished it is heard: by each message and request,
 * and for as long as a request waits for its answer.
 */
import type { AliveDriver, CommandRecord, Drivers, ScriptView } from "@corridor/protocol";
import type { Clock } from "../clock.ts";
import { keyId } from "../keys.ts";
import type { StoredScript } from "../store/session-store.ts";
import { limits } from "./limits.ts";
import { ScriptList } from "./script-list.ts";

/** Whoever was silent for longer holds no motion any more. */
const FORGET_MS = 10_000;
/** Beyond these nobody is told of: their motions end, that is all. */
export const MOST_TOLD = 16;

/** What the page is told of its scripts. */
export interface Scripts extends Drivers {
  /** those that may hold a motion */
  alive: AliveDriver[];
  /** by name */
  scripts: ScriptView[];
}

interface Life {
  heardAt: number;
  /** requests that wait for their answer */
  waiting: number;
  /** when its newest line was opened */
  lineAt: number | null;
}

export class DriverRoster {
  readonly #clock: Clock;
  readonly #tell: () => void;
  /** the same scripts by name */
  readonly #list: ScriptList;
  readonly #away: () => readonly StoredScript[];
  /** by the hash of its key */
  readonly #lives = new Map<string, Life>();
  #connected = 0;
  #client: string | null = null;
  #heardAt: number | null = null;
  #cancelTimer: (() => void) | null = null;
  #isNews = false;

  /**
   * @param tell is called when there is something new to be told
   * @param away the scripts that the owner has sent away
   */
  constructor(clock: Clock, tell: () => void, away: () => readonly StoredScript[]) {
    this.#clock = clock;
    this.#tell = tell;
    this.#list = new ScriptList(clock);
    this.#away = away;
  }

  /** A script was heard, and waits for nothing. */
  spoke(script: StoredScript): void {
    const now = this.#clock.now();
    this.#lifeOf(script.driver, now);
    this.#list.spoke(script, now);
    this.#client = script.client;
    this.#heardAt = now;
    this.#changed();
  }

  /** A script was heard. @returns to be called once its request is answered */
  heard(script: StoredScript): () => void {
    const life = this.#lifeOf(script.driver);
    const listed = this.#list.heard(script);
    this.#client = script.client;
    this.#heardAt = this.#clock.now();
    life.waiting += 1;
    this.#changed();
    let isWaiting = true;
    return () => {
      if (!isWaiting) return;
      isWaiting = false;
      listed();
      life.waiting -= 1;
      life.heardAt = this.#clock.now();
      this.#changed();
    };
  }

  /** A script's socket or stream was opened. @returns to be called when it is closed */
  connected(script: StoredScript): () => void {
    this.#connected += 1;
    const listed = this.#list.connected(script);
    this.#lifeOf(script.driver).lineAt = this.#clock.now();
    // At once: what a script kept while it had no line may come right behind.
    this.#flush();
    return () => {
      this.#connected -= 1;
      listed();
      this.#changed();
    };
  }

  /** A script's command was taken. */
  sent(script: StoredScript, record: CommandRecord): void {
    this.#list.sent(script, record);
    this.#changed();
  }

  /** Who may drive has changed: told at once, for somebody has pressed a button and looks. */
  awayChanged(): void {
    this.#flush();
  }

  told(): Scripts {
    return { ...this.now(), alive: this.alive(), scripts: this.#list.told(this.#away()) };
  }

  now(): Drivers {
    const silentMs = this.#heardAt === null ? null : Math.max(0, this.#clock.now() - this.#heardAt);
    return { connected: this.#connected, client: this.#client, silentMs };
  }

  /** The scripts that may hold a motion. */
  alive(): AliveDriver[] {
    const now = this.#clock.now();
    return [...this.#lives]
      .map(([driver, { heardAt, waiting, lineAt }]) => ({
        driver: keyId(driver),
        silentMs: waiting > 0 ? 0 : Math.max(0, now - heardAt),
        connectionMs: lineAt === null ? null : Math.max(0, now - lineAt),
      }))
      .toSorted((a, b) => a.silentMs - b.silentMs)
      .slice(0, MOST_TOLD);
  }

  close(): void {
    this.#cancelTimer?.();
    this.#cancelTimer = null;
  }

  #lifeOf(driver: string, now = this.#clock.now()): Life {
    let life = this.#lives.get(driver);
    if (life === undefined) {
      life = { heardAt: now, waiting: 0, lineAt: null };
      this.#lives.set(driver, life);
    }
    life.heardAt = now;
    return life;
  }

  #changed(): void {
    this.#isNews = true;
    if (this.#cancelTimer === null) this.#flush();
  }

  #flush(): void {
    this.#cancelTimer?.();
    this.#isNews = false;
    this.#forgetSilent();
    this.#tell();
    this.#cancelTimer = this.#clock.after(limits.driversIntervalMs, () => {
      this.#cancelTimer = null;
      const isWaiting = [...this.#lives.values()].some(({ waiting }) => waiting > 0);
      if (this.#isNews || isWaiting) this.#flush();
    });
  }

  #forgetSilent(): void {
    const before = this.#clock.now() - FORGET_MS;
    for (const [driver, { heardAt, waiting }] of this.#lives) {
      if (waiting === 0 && heardAt < before) this.#lives.delete(driver);
    }
  }
}
