/**
 * The steps of a robot: what they receive and return, and the robot as a step reads and changes it.
 * A store applies a step to the robot, and commits the changes if nothing else has changed the robot
 * since. It knows no rule.
 */
import type { CommandRecord, Ending, Pose, RemoteCommand } from "@corridor/protocol";
import type { LeftCause } from "./reasons.ts";
import type { CommandRow, Overtaking, RobotCommands, TermedRecord } from "./robot-commands.ts";

export interface NewCommand {
  /** hash of the key that sent it: the scope of `key` */
  driver: string;
  /** id of the script that sent it */
  script: string | null;
  /** the idempotency key, or null */
  key: string | null;
  command: RemoteCommand;
  acceptedAt: number;
  /** ms within which it must start, for the text of its expiry */
  ttl: number;
  /** wall-clock time by which it must start */
  deadline: number;
  /** supersedes all accepted commands */
  replace: boolean;
  /** ms for which a drive continues without a renewal, if the sender chose it */
  lease: number | null;
  /** earliest time at which a reset is accepted */
  resetFrom: number;
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
  /** the owner does not let scripts reset the robot */
  | { outcome: "reset-disabled" }
  /** a reset before `resetFrom` */
  | { outcome: "too-soon" }
  | { outcome: "no-robot" };

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

/** The expired commands, and the next deadline of the waiting ones; null: none waits. */
export interface Expired {
  ended: TermedRecord[];
  next: number | null;
}

export interface Acquired {
  epoch: number;
  changed: CommandRecord[];
  /** records whose ending differs from the page's report */
  refused: CommandRecord[];
}

/** A command accepted further in the future than this shows that the clock was set back. */
export const CLOCK_TOLERANCE_MS = 2_000;

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
  knownEpoch: number | null;
  /** why the commands of the previous page end */
  left: LeftCause;
}

/** own: acts as the robot's page. drive: sends commands and reads. watch: reads. */
export const keyKinds = ["own", "drive", "watch"] as const;
export type KeyKind = (typeof keyKinds)[number];

export interface StoredKey {
  kind: KeyKind;
  /** accepted in paths of gateways only; absent for other keys */
  use?: "url";
  /** SHA-256 of the key, as base64url */
  hash: string;
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

export interface KeyChange {
  add: StoredKey[];
  /** hashes */
  remove: string[];
  /** also removes all keys of this kind and use */
  removeKind: Pick<StoredKey, "kind" | "use"> | null;
  /** limit for the number of keys; adding beyond it fails */
  most: number;
  now: number;
}

export type KeysResult =
  /** `ended`: accepted commands of removed keys, which are now cancelled */
  | { outcome: "changed"; keys: StoredKey[]; ended: TermedRecord[] }
  | { outcome: "full" }
  | { outcome: "no-robot" };

export interface ScriptChange {
  add: StoredScript | null;
  /** id */
  remove: string | null;
  /** limit for the number of blocked scripts; adding beyond it fails */
  most: number;
}

export type BlockResult =
  /** `ended`: accepted commands of the script, which are now cancelled */
  | { outcome: "changed"; blocked: StoredScript[]; ended: TermedRecord[] }
  | { outcome: "full" }
  | { outcome: "no-robot" };

/** The keys and the blocked scripts of a robot. */
export interface Permissions {
  keys: StoredKey[];
  blocked: StoredScript[];
}

/** Finds commands in any state. The state machine itself holds only those in memory. */
export interface CommandLookup {
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

export interface RobotState extends CommandLookup {
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
