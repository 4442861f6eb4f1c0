/**
 * A robot as a step reads and changes it, and the form of a step. A store applies a step to the
 * robot, and commits the changes if nothing else has changed the robot since. It knows no rule.
 */
import type { CommandRow } from "./command-row.ts";
import type { Overtaking } from "./overtaking.ts";
import type { RobotCommands } from "./robot-commands.ts";
import type { Permissions, StoredKey, StoredScript } from "./steps.ts";

/** Finds commands in any state. The state machine itself holds only those in memory. */
export interface KnownCommands {
  row(seq: number): CommandRow | null;
  /** The command with this idempotency key. */
  withKey(driver: string, key: string): CommandRow | null;
  /** The highest seq of a command after `after` that overtakes in this way. */
  newest(overtakes: Overtaking, after: number): number | null;
  /** The ended commands with a seq above `after` and up to `upTo`. */
  ended(range: SeqRange): CommandRow[];
}

export interface SeqRange {
  after: number;
  upTo: number;
}

export interface KeysChange {
  /** all keys of the robot from now on */
  keys: StoredKey[];
  added: readonly StoredKey[];
  /** hashes */
  revoked: readonly string[];
  now: number;
}

export interface RobotState extends KnownCommands {
  readonly commands: RobotCommands;
  readonly permissions: Permissions;
  /** whether another running relay is connected to the robot's page */
  readonly isHeldElsewhere: boolean;
  setKeys(change: KeysChange): void;
  setBlocked(blocked: readonly StoredScript[]): void;
  /** Stores the page that acquires the robot with the current epoch. */
  setPage(name: string): void;
}

/** What a step needs to know besides the commands in memory. */
export interface Lookup {
  /** commands by seq */
  seqs?: readonly number[];
  /** the command with this idempotency key */
  key?: { driver: string; key: string } | null;
  /** all commands after this seq; null: none */
  after?: number | null;
  /** `ended` of this range; null: none */
  ended?: SeqRange | null;
  /** `isHeldElsewhere` */
  holder?: boolean;
}

export interface RobotStep<T> {
  /** result if there is no such robot */
  none: T;
  /** it changes more of the robot than its commands */
  changesRobot?: boolean;
  /** it is refused on a full disk; steps without it must always be possible */
  needsSpace?: boolean;
  /** what a store must find for the step, if it must read before the step; default: nothing */
  lookup?: (commands: RobotCommands) => Lookup;
  /** Changes the robot. A store may repeat it on a newer state. */
  apply(robot: RobotState): T;
}
