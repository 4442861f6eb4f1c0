/**
 * Storage of the relay: robot sessions, their hashed keys and the state of every command.
 *
 * Each method is one atomic step, so that several relays can share a store. An ended command never
 * changes again: every transition names the states that it starts from, and the first writer wins.
 * Times are wall-clock milliseconds since 1970. Every implementation passes
 * `testing/store.cases.ts`.
 */
import type { Command, CommandRecord, Ending, Pose } from "@corridor/protocol";

/** own: acts as the robot's page. drive: sends commands and reads. watch: reads. */
export const keyKinds = ["own", "drive", "watch"] as const;
export type KeyKind = (typeof keyKinds)[number];

export interface StoredKey {
  kind: KeyKind;
  /** SHA-256 of the key, as base64url */
  hash: string;
}

/** When a key was created and last used, as far as recorded; null: never used. */
export interface KeyTimes {
  hash: string;
  createdAt: number;
  lastUsedAt: number | null;
}

/** A use of a key. */
export interface KeyUse {
  hash: string;
  at: number;
}

/** A script that the robot's owner has blocked. */
export interface StoredScript {
  id: string;
  /** hash of its key */
  driver: string;
  /** the script's name for itself */
  name: string | null;
  /** the script's language */
  client: string;
}

export interface StoredSession {
  id: string;
  /** incremented each time a page acquires the robot; 0 before the first */
  epoch: number;
  /**
   * id by which the last owning page identifies itself on each connection; empty if it sent none
   */
  page: string;
  createdAt: number;
  lastUsedAt: number;
  keys: StoredKey[];
  away: StoredScript[];
  /** the owner has paused all scripts */
  isPaused: boolean;
}

export interface KeyChange {
  add: StoredKey[];
  /** hashes */
  remove: string[];
  /** also removes all keys of this kind */
  removeKind: KeyKind | null;
  /** why the commands of removed keys are cancelled */
  reason: string;
  /** limit for the number of keys; adding beyond it fails */
  most: number;
  now: number;
}

export type KeysResult =
  /** `ended`: accepted commands of removed keys, which are now cancelled */
  | { outcome: "changed"; keys: StoredKey[]; ended: TermedRecord[] }
  | { outcome: "full" }
  | { outcome: "no-session" };

export interface ScriptChange {
  add: StoredScript | null;
  /** id */
  remove: string | null;
  /** why the commands of the script are cancelled */
  reason: string;
  /** limit for the number of blocked scripts; adding beyond it fails */
  most: number;
}

export type AwayResult =
  /** `ended`: accepted commands of the script, which are now cancelled */
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
  /** ms within which it must start, for the text of its expiry */
  ttl: number;
  /** wall-clock time by which it must start */
  deadline: number;
  /** supersedes all accepted commands */
  replace: boolean;
  /** ms for which a drive continues without a renewal, if the sender chose it */
  lease: number | null;
  /** limit for the number of accepted commands; stops are never rejected */
  maxWaiting: number;
  /**
   * number of newest commands to retain; older ones that have ended are deleted with their keys; at
   * least 1
   */
  keep: number;
}

export type AddResult =
  /** `ended`: commands that a stop or a replacing command has ended */
  | { outcome: "stored"; record: CommandRecord; ended: TermedRecord[] }
  | { outcome: "duplicate"; record: CommandRecord }
  /** an earlier command has the same idempotency key and a different body */
  | { outcome: "conflict"; record: CommandRecord }
  | { outcome: "full" }
  /** its deadline had passed on arrival, and its idempotency key is new */
  | { outcome: "late" }
  /** the key that sent it is no longer a key of this robot */
  | { outcome: "revoked" }
  /** the script that sent it is blocked */
  | { outcome: "blocked" }
  /** the owner has paused all scripts */
  | { outcome: "paused" }
  | { outcome: "no-session" };

/** A record with the command details that only the relay and the robot need. */
export interface TermedRecord {
  record: CommandRecord;
  /** hash of the key that sent it */
  driver: string;
  /** id of the script that sent it; null if an earlier version of Corridor stored it */
  script: string | null;
  ttl: number;
  deadline: number;
  replace: boolean;
  lease: number | null;
}

export type CancelResult =
  | { outcome: "cancelled"; termed: TermedRecord }
  /** it is delivered or started, so the robot must end it */
  | { outcome: "delivered"; record: CommandRecord }
  | { outcome: "over"; record: CommandRecord }
  | { outcome: "not-yours" }
  | { outcome: "no-command" };

export type EndResult =
  | { outcome: "ended"; record: CommandRecord }
  /** this page cannot end it, or it has ended; null: there is no such command */
  | { outcome: "over"; record: CommandRecord | null };

/** A command accepted further in the future than this shows that the clock was set back. */
export const CLOCK_TOLERANCE_MS = 2_000;

/**
 * Reasons for ending commands of the previous page if it can neither end them nor report their
 * start.
 */
export interface LeftReasons {
  /** delivered, and not known whether it has started */
  delivered: string;
  started: string;
}

/** The previous page is gone, and this one was loaded in its place. */
export const reloadReasons: LeftReasons = {
  delivered:
    "The robot's page was reloaded, and this command may have started. Check where the robot is, then send a new command.",
  started: "The robot's page was reloaded and ended this command. Send a new command.",
};

/** The previous page may still exist. */
export const replacedReasons: LeftReasons = {
  delivered:
    "Another page took over the robot, and this command may have started. Check where the robot is, then send a new command.",
  started: "Another page took over the robot and ended this command. Send a new command.",
};

export interface PageState {
  /** the page has started or ended every command up to this seq that it received */
  lastApplied: number;
  /** the page was reloaded, so a started command can no longer end by itself */
  fresh: boolean;
  endings: Ending[];
  /** pose of the page's robot, where commands that are cancelled now end; null if unknown */
  pose: Pose | null;
  /** id by which the page identifies itself on each connection, if it sent one */
  page?: string | undefined;
  /**
   * Epoch of the previous owner if it is known which commands that page has not started; null:
   * unknown. Has no effect if another page has acquired the robot since.
   */
  settled: number | null;
  /** reasons for ending the commands of the previous page */
  left: LeftReasons;
}

export interface SessionStore {
  create(
    session: Omit<StoredSession, "epoch" | "page" | "lastUsedAt" | "away" | "isPaused">,
  ): Promise<void>;
  find(id: string): Promise<StoredSession | null>;
  /**
   * Creates and revokes keys in one step, and cancels the commands of revoked keys; see `cancel`.
   * Scripts of a revoked key are removed from the blocked ones.
   */
  changeKeys(id: string, change: KeyChange): Promise<KeysResult>;
  /** Blocks a script and cancels its commands, or unblocks a script. Blocking is idempotent. */
  changeAway(id: string, change: ScriptChange): Promise<AwayResult>;
  /**
   * Pauses remote driving and cancels all commands except stops, or resumes it.
   * @param reason why the commands are cancelled
   * @returns the accepted commands that ended; null if there is no such session
   */
  pause(id: string, isPaused: boolean, reason: string): Promise<TermedRecord[] | null>;
  /**
   * Stores the maze that the robot is in, in place of the previous one.
   * @param text the document as JSON
   * @returns false if there is no such session
   */
  keepMaze(id: string, text: string): Promise<boolean>;
  /** The maze that the robot is in; null if none is stored. */
  maze(id: string): Promise<string | null>;
  /** Times of the session's keys, in no particular order. */
  keyTimes(id: string): Promise<KeyTimes[]>;
  /** Records a use of the session and of its keys. Times never decrease. */
  touch(id: string, now: number, keys: readonly KeyUse[]): Promise<void>;
  /** Deletes the session and all of its data. @returns false if there was none */
  remove(id: string): Promise<boolean>;
  /** Deletes sessions last used or created before these times. @returns their ids */
  removeExpired(before: { lastUsedAt: number; createdAt: number }): Promise<string[]>;

  /**
   * Stores a command as accepted with the next seq, and deletes old ended commands. A stop cancels
   * all accepted commands, and a replacing command supersedes them. A known idempotency key returns
   * its earlier record, even after the deadline and while scripts are paused.
   */
  add(id: string, command: NewCommand): Promise<AddResult>;
  /**
   * Marks the next accepted commands as delivered, in order. At most `window` commands are
   * delivered at a time. Stops and replacing commands do not count and do not wait. Commands that
   * are due to expire are skipped.
   */
  deliver(id: string, epoch: number, window: number, now: number): Promise<TermedRecord[]>;
  /** Whether it is known without a query that `deliver` would return nothing now. */
  hasAll(id: string, window: number): boolean;
  /**
   * accepted → expired, for commands whose deadline has passed or whose acceptance is in the
   * future. The latter shows that the clock was set back, so their age is unknown.
   * @returns the expired commands, and the next deadline of the waiting ones; null: none waits
   */
  expire(id: string, now: number): Promise<{ ended: TermedRecord[]; next: number | null }>;
  /**
   * Cancels a command for the driver that sent it: accepted → cancelled. If the robot has the
   * command, the request is stored and the robot is asked to end it. If the robot turns out not to
   * have received it, it is cancelled.
   */
  cancel(id: string, seq: number, by: { driver: string; reason: string }): Promise<CancelResult>;
  /** delivered → started. @returns null if it was not delivered or the epoch is not the newest */
  start(id: string, epoch: number, seq: number): Promise<CommandRecord | null>;
  /** delivered or started → its ending, reported by the page of the newest epoch. */
  end(id: string, epoch: number, ending: Ending): Promise<EndResult>;
  /**
   * Gives up a page that does not return: increments the epoch, so that its later reports are
   * ignored, and cancels all delivered and started commands. Does nothing if a newer page exists.
   * @returns the commands that ended; null if another running relay is connected to the page
   */
  abandon(id: string, epoch: number, reason: string): Promise<CommandRecord[] | null>;
  /**
   * Makes a page the owner of the robot: increments the epoch and stores what the page has done.
   * Commands that were not started return to accepted, unless they were cancelled, stopped or
   * superseded meanwhile. If it is unknown whether they started, they end as cancelled; see
   * `PageState.settled`.
   * @returns the changed records, and the records whose ending differs from the page's report; null
   *   if there is no such session
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
  /**
   * Commands that the robot has and whose cancellation was requested, in order, with the reasons.
   */
  recalled(id: string): Promise<{ seq: number; reason: string }[]>;
  /**
   * Checks whether the store is writable, by writing.
   * @returns full: it responds, but has no free space
   * @throws Error if it does not respond
   */
  check(): Promise<"ok" | "full">;
  close(): Promise<void>;
}
