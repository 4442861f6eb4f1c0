/**
 * Storage of the relay: robots, their hashed keys and the state of every command.
 *
 * Each method is one atomic step, so that several relays can share a store. An ended command never
 * changes again: every transition names the states that it starts from, and the first writer wins.
 * Times are wall-clock milliseconds since 1970. Every implementation passes
 * `cases/store.cases.ts`.
 */
import type { CommandRecord, Ending, RecallCause } from "@corridor/protocol";
import type {
  BlockResult,
  KeyChange,
  KeysResult,
  ScriptChange,
  StoredKey,
  StoredScript,
} from "../commands/permissions.ts";
import type {
  AddResult,
  CancelResult,
  EndResult,
  NewCommand,
  PageState,
  TermedRecord,
} from "../commands/steps.ts";

export {
  keyKinds,
  type BlockResult,
  type KeyChange,
  type KeyKind,
  type KeysResult,
  type ScriptChange,
  type StoredKey,
  type StoredScript,
} from "../commands/permissions.ts";
export type { LeftCause } from "../commands/reasons.ts";
export {
  CLOCK_TOLERANCE_MS,
  type AddResult,
  type CancelResult,
  type EndResult,
  type NewCommand,
  type PageState,
  type TermedRecord,
} from "../commands/steps.ts";

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

export interface StoredRobot {
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
  blocked: StoredScript[];
  /** the owner has paused all scripts */
  isPaused: boolean;
}

export interface RobotStore {
  create(
    robot: Omit<StoredRobot, "epoch" | "page" | "lastUsedAt" | "blocked" | "isPaused">,
  ): Promise<void>;
  find(id: string): Promise<StoredRobot | null>;
  /**
   * Creates and revokes keys in one step, and cancels the commands of revoked keys; see `cancel`.
   * Scripts of a revoked key are removed from the blocked ones.
   */
  changeKeys(id: string, change: KeyChange): Promise<KeysResult>;
  /** Blocks a script and cancels its commands, or unblocks a script. Blocking is idempotent. */
  changeBlocked(id: string, change: ScriptChange): Promise<BlockResult>;
  /**
   * Pauses remote driving and cancels all commands except stops, or resumes it.
   * @returns the accepted commands that ended; null if there is no such robot
   */
  pause(id: string, isPaused: boolean): Promise<TermedRecord[] | null>;
  /**
   * Stores the maze that the robot is in, in place of the previous one.
   * @param text the document as JSON
   * @returns false if there is no such robot
   */
  storeMaze(id: string, text: string): Promise<boolean>;
  /** The maze that the robot is in; null if none is stored. */
  maze(id: string): Promise<string | null>;
  /** Times of the robot's keys, in no particular order. */
  keyTimes(id: string): Promise<KeyTimes[]>;
  /** Records a use of the robot and of its keys. Times never decrease. */
  touch(id: string, now: number, keys: readonly KeyUse[]): Promise<void>;
  /** Deletes the robot and all of its data. @returns false if there was none */
  remove(id: string): Promise<boolean>;
  /** Deletes robots last used or created before these times. @returns their ids */
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
   * @param isAbsent whether no page is connected as the robot, for the cause
   * @returns the expired commands, and the next deadline of the waiting ones; null: none waits
   */
  expire(
    id: string,
    now: number,
    isAbsent?: boolean,
  ): Promise<{ ended: TermedRecord[]; next: number | null }>;
  /**
   * Cancels a command for the driver that sent it: accepted → cancelled. If the robot has the
   * command, the request is stored and the robot is asked to end it. If the robot turns out not to
   * have received it, it is cancelled.
   */
  cancel(id: string, seq: number, driver: string): Promise<CancelResult>;
  /** delivered → started. @returns null if it was not delivered or the epoch is not the newest */
  start(id: string, epoch: number, seq: number): Promise<CommandRecord | null>;
  /** delivered or started → its ending, reported by the page of the newest epoch. */
  end(id: string, epoch: number, ending: Ending): Promise<EndResult>;
  /**
   * Gives up a page that does not return: increments the epoch, so that its later reports are
   * ignored, and cancels all delivered and started commands. Does nothing if a newer page exists.
   * @returns the commands that ended; null if another running relay is connected to the page
   */
  abandon(id: string, epoch: number): Promise<CommandRecord[] | null>;
  /**
   * Makes a page the owner of the robot: increments the epoch and stores what the page has done.
   * Commands that were not started return to accepted, unless they were cancelled, stopped or
   * superseded meanwhile. If it is unknown whether they started, they end as cancelled; see
   * `PageState.settled`.
   * @returns the changed records, and the records whose ending differs from the page's report; null
   *   if there is no such robot
   */
  acquire(
    id: string,
    page: PageState,
  ): Promise<{ epoch: number; changed: CommandRecord[]; refused: CommandRecord[] } | null>;

  command(id: string, seq: number): Promise<CommandRecord | null>;
  /** Commands with a higher seq, in order. */
  commandsAfter(id: string, seq: number, limit: number): Promise<CommandRecord[]>;
  /** The commands that have not ended, in order. */
  openCommands(id: string): Promise<CommandRecord[]>;
  /**
   * Commands that the robot has and whose cancellation was requested, in order.
   */
  recalled(id: string): Promise<{ seq: number; cause: RecallCause }[]>;
  /**
   * Checks whether the store is writable, by writing.
   * @returns full: it responds, but has no free space
   * @throws Error if it does not respond
   */
  check(): Promise<"ok" | "full">;
  close(): Promise<void>;
}
