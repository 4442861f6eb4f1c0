/**
 * What the relay keeps: robot sessions, their keys (hashed) and the life of every command.
 *
 * Each method is one atomic step, so that several relays can share a store. An ending is for ever:
 * every change of state names the states that it may come from, and the first writer wins.
 * Wall-clock times are milliseconds since 1970. Every implementation passes `testing/store.cases.ts`.
 */
import type { Command, CommandRecord, Ending } from "@corridor/protocol";

/** own: be the robot's page. drive: send commands and read. */
export type KeyKind = "own" | "drive";

export interface StoredKey {
  kind: KeyKind;
  /** SHA-256 of the key, as base64url */
  hash: string;
}

export interface StoredSession {
  id: string;
  /** raised each time a page takes the robot; 0 before the first */
  epoch: number;
  createdAt: number;
  lastUsedAt: number;
  keys: StoredKey[];
}

export interface NewCommand {
  /** hash of the key that sent it: the scope of `key` */
  driver: string;
  /** the idempotency key, or null */
  key: string | null;
  command: Command;
  acceptedAt: number;
  /** refuse when so many commands wait already (a stop is never refused) */
  maxWaiting: number;
  /** forget what has ended, with its key, before the newest so many commands; at least 1 */
  keep: number;
}

export type AddResult =
  /** `ended`: what a stop has overtaken */
  | { outcome: "stored"; record: CommandRecord; ended: CommandRecord[] }
  | { outcome: "duplicate"; record: CommandRecord }
  /** the same idempotency key came with another command */
  | { outcome: "conflict"; record: CommandRecord }
  | { outcome: "full" }
  | { outcome: "no-session" };

export interface PageState {
  /** highest seq that the page has started or ended */
  lastApplied: number;
  /** the page was loaded anew: what had started can never end by itself */
  fresh: boolean;
  endings: Ending[];
}

export interface SessionStore {
  create(session: Omit<StoredSession, "epoch" | "lastUsedAt">): Promise<void>;
  find(id: string): Promise<StoredSession | null>;
  /** Notes that the session is in use. */
  touch(id: string, now: number): Promise<void>;
  /** Deletes the session and everything of it. @returns false when there was none */
  remove(id: string): Promise<boolean>;
  /** Deletes sessions last used or created before these times. @returns their ids */
  removeExpired(before: { lastUsedAt: number; createdAt: number }): Promise<string[]>;

  /**
   * Stores a command as accepted, with the next seq, and forgets old ones that have ended. A stop
   * cancels all that are accepted.
   */
  add(id: string, command: NewCommand): Promise<AddResult>;
  /**
   * Marks the next accepted commands, in order, as delivered, so that at most `window` are delivered
   * at a time. A stop does not count and does not wait.
   */
  deliver(id: string, epoch: number, window: number): Promise<CommandRecord[]>;
  /** delivered → started. @returns null when it was not delivered */
  start(id: string, seq: number): Promise<CommandRecord | null>;
  /** delivered or started → its ending. @returns null when it has ended before */
  end(id: string, ending: Ending): Promise<CommandRecord | null>;
  /** Ends all that is delivered or started as cancelled. @returns what has ended by this */
  cancelOpen(id: string, reason: string): Promise<CommandRecord[]>;
  /**
   * A page takes the robot: raises the epoch, stores what the page has done, and makes what never
   * reached it wait again. @returns null when there is no such session
   */
  takeOver(
    id: string,
    page: PageState,
  ): Promise<{ epoch: number; changed: CommandRecord[] } | null>;

  command(id: string, seq: number): Promise<CommandRecord | null>;
  /** Commands with a higher seq, in order. */
  commandsAfter(id: string, seq: number, limit: number): Promise<CommandRecord[]>;
  /** The commands that have not ended, in order. */
  openCommands(id: string): Promise<CommandRecord[]>;
  /**
   * Whether the store can be written, found out by writing.
   * @returns full: it answers, and has no room left
   * @throws Error when it does not answer
   */
  check(): Promise<"ok" | "full">;
  close(): Promise<void>;
}
