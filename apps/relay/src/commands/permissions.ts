/** What a robot's owner permits: its keys, and the scripts that are blocked. */
import type { RobotCommands, Standing } from "./robot-commands.ts";
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
  | { outcome: "no-robot" };

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
  | { outcome: "no-robot" };

/** The keys and the blocked scripts of a robot. */
export interface Permissions {
  keys: StoredKey[];
  away: StoredScript[];
}

/**
 * Creates and revokes keys, and recalls the commands of revoked ones. Their scripts are no longer
 * blocked, because they cannot return.
 * @returns what exists now, and the hashes of the revoked keys; null if there are too many
 */
export function changeKeys(
  robot: RobotCommands,
  before: Permissions,
  { add, remove, removeKind, most, reason }: KeyChange,
): (Permissions & { revoked: string[]; ended: TermedRecord[] }) | null {
  const isRevoked = ({ hash, kind }: StoredKey): boolean =>
    remove.includes(hash) || kind === removeKind;
  const keys = [...before.keys.filter((key) => !isRevoked(key)), ...add];
  if (add.length > 0 && keys.length > most) return null;
  const revoked = before.keys.filter(isRevoked).map(({ hash }) => hash);
  const away = before.away.filter(({ driver }) => !revoked.includes(driver));
  Object.assign(robot.standing, standingOf({ keys, away }));
  const ended = revoked.flatMap((driver) => recallAllOf(robot, { driver }, reason));
  return { keys, away, revoked, ended };
}

/** What of the permissions decides whether a command is accepted. */
export function standingOf({ keys, away }: Permissions): Pick<Standing, "keys" | "away"> {
  return {
    keys: new Set(keys.map(({ hash }) => hash)),
    away: new Set(away.map(({ id }) => id)),
  };
}

/**
 * Blocks a script and recalls its commands, or unblocks one.
 * @returns the blocked scripts; null if there are too many
 */
export function changeAway(
  robot: RobotCommands,
  all: readonly StoredScript[],
  { add, remove, most, reason }: ScriptChange,
): { away: StoredScript[]; ended: TermedRecord[] } | null {
  const away = all.filter(({ id }) => id !== remove);
  if (add !== null && !away.some(({ id }) => id === add.id)) {
    if (away.length >= most) return null;
    away.push(add);
  }
  robot.standing.away = new Set(away.map(({ id }) => id));
  const ended = add === null ? [] : recallAllOf(robot, { script: add.id }, reason);
  return { away, ended };
}
