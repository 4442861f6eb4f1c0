/** What a robot's owner permits: its keys, and the scripts that are blocked. */
import type { RobotCommands, AccessState } from "./robot-commands.ts";
import { recallAllOf } from "./state-machine.ts";
import type { TermedRecord } from "./steps.ts";

/** own: acts as the robot's page. drive: sends commands and reads. watch: reads. */
export const keyKinds = ["own", "drive", "watch"] as const;
export type KeyKind = (typeof keyKinds)[number];

export interface StoredKey {
  kind: KeyKind;
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
  /** also removes all keys of this kind */
  removeKind: KeyKind | null;
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

/**
 * Creates and revokes keys, and recalls the commands of revoked ones. Their scripts are no longer
 * blocked, because they cannot return.
 * @returns what exists now, and the hashes of the revoked keys; null if there are too many
 */
export function changeKeys(
  robot: RobotCommands,
  before: Permissions,
  { add, remove, removeKind, most }: KeyChange,
): (Permissions & { revoked: string[]; ended: TermedRecord[] }) | null {
  const isRevoked = ({ hash, kind }: StoredKey): boolean =>
    remove.includes(hash) || kind === removeKind;
  const keys = [...before.keys.filter((key) => !isRevoked(key)), ...add];
  if (add.length > 0 && keys.length > most) return null;
  const revoked = before.keys.filter(isRevoked).map(({ hash }) => hash);
  const blocked = before.blocked.filter(({ driver }) => !revoked.includes(driver));
  Object.assign(robot.accessState, accessStateOf({ keys, blocked }));
  const ended = revoked.flatMap((driver) => recallAllOf(robot, { driver }, "revoked"));
  return { keys, blocked, revoked, ended };
}

/** What of the permissions decides whether a command is accepted. */
export function accessStateOf({
  keys,
  blocked,
}: Permissions): Pick<AccessState, "keys" | "blocked"> {
  return {
    keys: new Set(keys.map(({ hash }) => hash)),
    blocked: new Set(blocked.map(({ id }) => id)),
  };
}

/**
 * Blocks a script and recalls its commands, or unblocks one.
 * @returns the blocked scripts; null if there are too many
 */
export function changeBlocked(
  robot: RobotCommands,
  all: readonly StoredScript[],
  { add, remove, most }: ScriptChange,
): { blocked: StoredScript[]; ended: TermedRecord[] } | null {
  const blocked = all.filter(({ id }) => id !== remove);
  if (add !== null && !blocked.some(({ id }) => id === add.id)) {
    if (blocked.length >= most) return null;
    blocked.push(add);
  }
  robot.accessState.blocked = new Set(blocked.map(({ id }) => id));
  const ended = add === null ? [] : recallAllOf(robot, { script: add.id }, "blocked");
  return { blocked, ended };
}
