/**
 * What the relay keeps: robot sessions, their keys (hashed) and the life of every command.
 *
 * Each method is one atomic step, so that several relays can share a store. An ending is for ever:
 * every change of state names the states that it may come from, and the first writer wins.
 * Wall-clock times are milliseconds since 1970. Every implementation passes `testing/store.cases.ts`.
 */
import type { Command, CommandRecord, Ending, Pose } from "@corridor/protocol";

/** own: be the robot's page. drive: send commands and read. watch: read. */
export const keyKinds = ["own", "drive", "watch"] as const;
export type KeyKind = (typeof keyKinds)[number];

export interface StoredKey {
  kind: KeyKind;
  /** SHA-256 of the key, as base64url */
  hash: string;
}

/** When a key was made, and when it was in use last as far as that was noted; null: never. */
export interface KeyTimes {
  hash: string;
  createdAt: number;
  lastUsedAt: number | null;
}

/** A key was in use at this time. */
export interface KeyUse {
  hash: string;
  at: number;
}

/** A script that its robot's owner has sent away. */
export interface StoredScript {
  id: string;
  /** hash of its key */
  driver: string;
  /** as it calls itself */
  name: string | null;
  /** its language */
  client: string;
}

export interface StoredSession {
  id: string;
  /** raised each time a page takes the robot; 0 before the first */
  epoch: number;
  /** by which the page that took it last is known on each of its lines; empty where that said nothing */
  page: string;
  createdAt: number;
  lastUsedAt: number;
  keys: StoredKey[];
  away: StoredScript[];
  /** the owner lets no script drive at the moment */
  isPaused: boolean;
}

export interface KeyChange {
  add: StoredKey[];
  /** hashes */
  remove: string[];
  /** all of this kind go, too */
  removeKind: KeyKind | null;
  /** why what they had sent is taken back */
  reason: string;
  /** refuse to add when there would be more */
  most: number;
  now: number;
}

export type KeysResult =
  /** `ended`: what waited and had been sent by a key that is gone */
  | { outcome: "changed"; keys: StoredKey[]; ended: TermedRecord[] }
  | { outcome: "full" }
  | { outcome: "no-session" };

export interface ScriptChange {
  add: StoredScript | null;
  /** id */
  remove: string | null;
  /** why what it had sent is taken back */
  reason: string;
  /** refuse to add when there would be more */
  most: number;
}

export type AwayResult =
  /** `ended`: what waited and had been sent by the script */
  | { outcome: "changed"; away: StoredScript[]; ended: TermedRecord[] }
  | { outcome: "full" }
  | { outcome: "no-session" };

export interface NewCommand {
  /** hash of the key that sent it: the scope of `key` */
  driver: string;
  /** id of the script that sent it */
  script: string | null;
  /** the idempotency key, or null */
  key: string | null;
  command: Command;
  acceptedAt: number;
  /** ms that it was given to start within, for the words with which it expires */
  ttl: number;
  /** wall-clock time by which it must have started */
  deadline: number;
  /** supersedes all that is accepted */
  replace: boolean;
  /** ms for which a drive goes on by itself, where its sender asked for some */
  lease: number | null;
  /** refuse when so many commands wait already (a stop is never refused) */
  maxWaiting: number;
  /** forget what has ended, with its key, before the newest so many commands; at least 1 */
  keep: number;
}

export type AddResult =
  /** `ended`: what a stop, or a command that replaces, has overtaken */
  | { outcome: "stored"; record: CommandRecord; ended: TermedRecord[] }
  | { outcome: "duplicate"; record: CommandRecord }
  /** the same idempotency key came with another command */
  | { outcome: "conflict"; record: CommandRecord }
  | { outcome: "full" }
  /** its deadline was past when it came, and its key is not known */
  | { outcome: "late" }
  /** the key that sent it is none of this robot's any more */
  | { outcome: "revoked" }
  /** the script that sent it is away */
  | { outcome: "blocked" }
  /** the owner lets no script drive at the moment */
  | { outcome: "paused" }
  | { outcome: "no-session" };

/** A record with what only the relay and the robot need of its command. */
export interface TermedRecord {
  record: CommandRecord;
  /** hash of the key that sent it */
  driver: string;
  /** id of the script that sent it; null where an earlier Corridor stored it */
  script: string | null;
  ttl: number;
  deadline: number;
  replace: boolean;
  lease: number | null;
}

export type CancelResult =
  | { outcome: "cancelled"; termed: TermedRecord }
  /** delivered or started: the robot's to end */
  | { outcome: "delivered"; record: CommandRecord }
  | { outcome: "over"; record: CommandRecord }
  | { outcome: "not-yours" }
  | { outcome: "no-command" };

export type EndResult =
  | { outcome: "ended"; record: CommandRecord }
  /** it is not this page's to end, or not any more; null: there is no such command */
  | { outcome: "over"; record: CommandRecord | null };

/** A command from so much later than now shows that the clock was set back. */
export const CLOCK_TOLERANCE_MS = 2_000;

/** Why a command ends that the page before was given, where that one can neither end it nor report that it began. */
export interface LeftReasons {
  /** delivered, and not known whether it has begun */
  delivered: string;
  started: string;
}

/** The page before is gone, and this one was loaded in its place. */
export const reloadReasons: LeftReasons = {
  delivered:
    "The robot's page was reloaded, and this command may have started. Check where the robot is, then send a new command.",
  started: "The robot's page was reloaded and ended this command. Send a new command.",
};

/** The page before may still be there. */
export const replacedReasons: LeftReasons = {
  delivered:
    "Another page took over the robot, and this command may have started. Check where the robot is, then send a new command.",
  started: "Another page took over the robot and ended this command. Send a new command.",
};

export interface PageState {
  /** the page has started or ended this command and all before it that it was given */
  lastApplied: number;
  /** the page was loaded anew: what had started can never end by itself */
  fresh: boolean;
  endings: Ending[];
  /** where its robot is: a command that is cancelled because the page came ends there; null where it is not known */
  pose: Pose | null;
  /** by which it is known on each of its lines, where it says so */
  page?: string | undefined;
  /**
   * Epoch of the page that had the robot last, where it is known what that one has not begun; null: nobody
   * knows. Of no effect where another page has taken the robot since.
   */
  settled: number | null;
  /** why commands end that the page before was given */
  left: LeftReasons;
}

export interface SessionStore {
  create(
    session: Omit<StoredSession, "epoch" | "page" | "lastUsedAt" | "away" | "isPaused">,
  ): Promise<void>;
  find(id: string): Promise<StoredSession | null>;
  /**
   * Makes and revokes keys in one step, and takes back what the revoked ones have sent: see `cancel`. Scripts
   * of a revoked key are not away any more: they are gone.
   */
  changeKeys(id: string, change: KeyChange): Promise<KeysResult>;
  /**
   * Sends a script away, once however often it is asked for, and takes back what it has sent; or lets one
   * back.
   */
  changeAway(id: string, change: ScriptChange): Promise<AwayResult>;
  /**
   * Pauses remote driving, and takes back all but stops; or lets scripts drive again.
   * @param reason why what they had sent is taken back
   * @returns what waited and has ended by this; null when there is no such session
   */
  pause(id: string, isPaused: boolean, reason: string): Promise<TermedRecord[] | null>;
  /**
   * Keeps the maze that the robot is in, in the place of the one before.
   * @param text of the document, as JSON
   * @returns false: there is no such session
   */
  keepMaze(id: string, text: string): Promise<boolean>;
  /** The maze that the robot is in; null where none was kept. */
  maze(id: string): Promise<string | null>;
  /** The times of its keys, in no order. */
  keyTimes(id: string): Promise<KeyTimes[]>;
  /** Notes that the session is in use, and its keys were; never sets a time back. */
  touch(id: string, now: number, keys: readonly KeyUse[]): Promise<void>;
  /** Deletes the session and everything of it. @returns false when there was none */
  remove(id: string): Promise<boolean>;
  /** Deletes sessions last used or created before these times. @returns their ids */
  removeExpired(before: { lastUsedAt: number; createdAt: number }): Promise<string[]>;

  /**
   * Stores a command as accepted, with the next seq, and forgets old ones that have ended. A stop
   * cancels all that are accepted, one that replaces supersedes them. A known key is answered first,
   * however late it comes again, and while scripts may not drive, too.
   */
  add(id: string, command: NewCommand): Promise<AddResult>;
  /**
   * Marks the next accepted commands, in order, as delivered, so that at most `window` are delivered
   * at a time. A stop, or a command that replaces, does not count and does not wait; what is due to
   * expire stays where it is.
   */
  deliver(id: string, epoch: number, window: number, now: number): Promise<TermedRecord[]>;
  /** Whether it is known, without asking for it, that `deliver` would find nothing now. */
  hasAll(id: string, window: number): boolean;
  /**
   * accepted → expired, for all whose deadline is past, and for those from a time that is yet to come:
   * then the clock was set back, and nobody knows how late it is.
   * @returns what has expired, and the next deadline of what waits; null: nothing waits
   */
  expire(id: string, now: number): Promise<{ ended: TermedRecord[]; next: number | null }>;
  /**
   * Takes one command back for the driver that sent it: accepted → cancelled. What the robot has keeps the
   * wish: the robot is asked, and where it turns out that it never got the command, that is cancelled.
   */
  cancel(id: string, seq: number, by: { driver: string; reason: string }): Promise<CancelResult>;
  /** delivered → started. @returns null when it was not delivered, or the epoch is not the newest */
  start(id: string, epoch: number, seq: number): Promise<CommandRecord | null>;
  /** delivered or started → its ending, by the page of the newest epoch. */
  end(id: string, epoch: number, ending: Ending): Promise<EndResult>;
  /**
   * The page with this epoch is away for good: raises the epoch, so that nothing of it counts any more,
   * and ends all that is delivered or started as cancelled. Does nothing when a newer page has come.
   * @returns what has ended by this; null: another relay that lives has the page
   */
  abandon(id: string, epoch: number, reason: string): Promise<CommandRecord[] | null>;
  /**
   * A page takes the robot: raises the epoch, stores what the page has done, and makes what was not begun
   * wait again, except what was taken back or what a later stop or replacing command has overtaken
   * meanwhile. Where nobody knows whether it was begun, it ends as cancelled: see `PageState.settled`.
   * @returns what has changed, and the records whose ending the page tells otherwise than it was; null
   *   when there is no such session
   */
  takeOver(
    id: string,
    page: PageState,
  ): Promise<{ epoch: number; changed: CommandRecord[]; refused: CommandRecord[] } | null>;

  command(id: string, seq: number): Promise<CommandRecord | null>;
  /** Commands with a higher seq, in order. */
  commandsAfter(id: string, seq: number, limit: number): Promise<CommandRecord[]>;
  /** The commands that have not ended, in order. */
  openCommands(id: string): Promise<CommandRecord[]>;
  /** The commands that were taken back and that the robot has, in order, and why they were. */
  recalled(id: string): Promise<{ seq: number; reason: string }[]>;
  /**
   * Whether the store can be written, found out by writing.
   * @returns full: it answers, and has no room left
   * @throws Error when it does not answer
   */
  check(): Promise<"ok" | "full">;
  close(): Promise<void>;
}
